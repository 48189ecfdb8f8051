//! What is mutated: the forms of the README, the files of the paper's examples, and documents and tables of these forms.

use std::fs;
use std::path::{Path, PathBuf};
use std::sync::OnceLock;

use crate::common::documentation::DOCUMENTATION;
use crate::common::pictures::Drawing;
use stellate::document::{Format, write_form};
use stellate::language::{Numbers, parse_form};
use stellate::shape::Form;

/// Forms besides those of the README: the corners of the language.
const FORMS: [&str; 14] = [
    "r = 1 + 1/5*cos(t) + 0.1*sin(t)",
    "x^4 - x^2 + y^2 = 0",
    "(x^2+y^2+z^2+3)^2 = 16*(x^2+y^2)",
    "x = 2*t/(1+t^2); y = (1-t^2)/(1+t^2)",
    "x = cos(3*t); y = sin(2*t)",
    "x = cos(theta)*sin(phi); y = cos(theta); z = cos(phi)",
    "x^2 + y^2 + z^2 = 1; x + y + z = 1/2",
    "superquadric 2d a1=2 a2=1 epsilon=1/2",
    "superquadric 3d a1=2 a2=1 a3=1 epsilon1=1/2 epsilon2=3",
    "0x1.8p+1*x^2 − 2xy + (x − y)**3/7 = 1e-5",
    "r = 3 # center: 1/2, -3",
    "x = (t - 1)^3*t/(t^2 + 2); y = t; z = 1/t",
    "((((x))))^2 + (y^2)^2^1 = 2(x)(y)",
    "r = cos(2*theta)^2 + sin(theta)*cos(theta)/3",
];

fn root() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR"))
}

fn read(path: &Path) -> String {
    fs::read_to_string(path).unwrap()
}

fn once(cell: &'static OnceLock<Vec<Vec<u8>>>, make: fn() -> Vec<Vec<u8>>) -> &'static [Vec<u8>] {
    cell.get_or_init(make)
}

/// Short formulas.
pub(crate) fn formulas() -> &'static [Vec<u8>] {
    static CELL: OnceLock<Vec<Vec<u8>>> = OnceLock::new();
    once(&CELL, || {
        let readme = DOCUMENTATION.map(|file| read(&root().join(file))).concat();
        let quoted = readme.split(['\'', '"']).filter(|text| text.len() < 200);
        let curve = read(&root().join("paper-examples/e09-sixth-degree/curve.txt"));
        let all = FORMS.iter().copied().chain(quoted).chain([curve.as_str()]);
        let forms = all.filter(|text| parse_form(text, "seed", Numbers::Exact).is_ok());
        let forms: Vec<Vec<u8>> = forms.map(|text| text.as_bytes().to_vec()).collect();
        assert!(forms.len() > 40, "the README has {} forms", forms.len());
        forms
    })
}

fn written(format: Format) -> Vec<Vec<u8>> {
    let texts = formulas()
        .iter()
        .map(|text| String::from_utf8(text.clone()).unwrap());
    let forms = texts.filter_map(|text| parse_form(&text, "seed", Numbers::Exact).ok());
    let write = |form: Form| {
        let mut out = Vec::new();
        let done = write_form(&form, &[], format, &mut out).is_ok();
        (done && out.len() < 20_000).then_some(out)
    };
    forms.filter_map(write).collect()
}

/// JSON documents.
pub(crate) fn documents() -> &'static [Vec<u8>] {
    static CELL: OnceLock<Vec<Vec<u8>>> = OnceLock::new();
    once(&CELL, || written(Format::Json))
}

/// Tables of coefficients of curves, surfaces and series.
pub(crate) fn coefficients() -> &'static [Vec<u8>] {
    static CELL: OnceLock<Vec<Vec<u8>>> = OnceLock::new();
    once(&CELL, || written(Format::Csv))
}

/// The first rows of the outlines and of the measured points of the paper's examples.
pub(crate) fn rows() -> &'static [Vec<u8>] {
    static CELL: OnceLock<Vec<Vec<u8>>> = OnceLock::new();
    once(&CELL, || {
        let names = [
            "e02-butterfly/butterfly.csv",
            "e02-jet/jet.csv",
            "e12-inspection/measured.csv",
        ];
        let files = names.map(|name| read(&root().join("paper-examples").join(name)));
        let part = |text: &String, count: usize| {
            let rows: Vec<&str> = text.lines().take(count).collect();
            rows.join("\n").into_bytes()
        };
        let parts = files
            .iter()
            .flat_map(|text| [8, 60, 1000].map(|n| part(text, n)));
        let others = [
            "theta,r\n0,1\n0.5,1.25\n",
            "x,y\n0,0\n1,0\n 0x1p-1 , 1\n",
            "0,0\n4,0\n4,4\n0,4\n",
        ];
        parts
            .chain(others.map(|text| text.as_bytes().to_vec()))
            .collect()
    })
}

/// Pictures of silhouettes as files.
pub(crate) fn pictures() -> &'static [Vec<u8>] {
    static CELL: OnceLock<Vec<Vec<u8>>> = OnceLock::new();
    once(&CELL, || {
        let names = ["e02-butterfly/butterfly.png", "e02-jet/jet.png"];
        let files = names.map(|name| fs::read(root().join("paper-examples").join(name)).unwrap());
        let small = Drawing::rgba([24, 20], |x, y| {
            let inside = (4..19).contains(&x) && (3..x.min(16)).contains(&y);
            if inside {
                [10, 20, 30, 255]
            } else {
                [250, 250, 250, 40]
            }
        });
        files
            .into_iter()
            .chain([small.bmp(), small.jpeg(75), small.png()])
            .collect()
    })
}
