//! What the program does a library user does in one call: every command of the README gives the same bytes either way.

#![expect(clippy::unwrap_used, reason = "a test fails by panicking")]

use std::collections::HashMap;
use std::fs;
use std::path::Path;

use crate::common::documentation::DOCUMENTATION;
use crate::common::program::run_in;
use stellate::document::{
    Format, InspectionWriter, MeshFormat, json_schema, write_check, write_described, write_fit,
    write_fit_table, write_implicitization, write_ladder, write_mesh, write_mesh_fit,
    write_parametrized, write_sampled, write_vectors,
};
use stellate::fit::{
    CenterChoice, FitModel, FitOptions, FitSize, MeshFitOptions, MeshFitSize, OutlineOptions,
};
use stellate::inspect::{ToleranceZone, Verdict};
use stellate::language::Numbers;
use stellate::picture::Window;
use stellate::sample::Direction;
use stellate::shape::{Form, ImplicitCurve};
use stellate::verb::{
    self, CoefficientScale, CoordinatesFrom, DescribeOptions, FigureFormat, FittedOutline,
    FloatKind, Frame, Given, ImplicitizeMethod, ImplicitizeOptions, InspectionOptions,
    MeshingOptions, ParametrizeOptions, PlotOptions, PointRows, PointSource, ReadOptions,
    ReadingOptions, SampleOptions, VectorOptions, Work,
};
use tempfile::TempDir;

/// The options without a value.
const FLAGS: [&str; 10] = [
    "feet",
    "topology",
    "positive",
    "solid",
    "quiet",
    "self",
    "repair",
    "normal-form",
    "cloud",
    "keep",
];

/// A command, taken apart.
struct Words {
    forms: Vec<String>,
    options: HashMap<String, Vec<String>>,
}

impl Words {
    fn new(words: &[String]) -> Self {
        let (mut forms, mut options) = (Vec::new(), HashMap::<String, Vec<String>>::new());
        let mut words = words.iter();
        while let Some(word) = words.next() {
            let Some(name) = word.strip_prefix('-') else {
                forms.push(word.clone());
                continue;
            };
            let name = name.trim_start_matches('-');
            let (name, value) = match name.split_once('=') {
                Some((name, value)) => (name, value.to_owned()),
                None if FLAGS.contains(&name) => (name, String::new()),
                None => (name, words.next().unwrap().clone()),
            };
            options.entry(name.into()).or_default().push(value);
        }
        Self { forms, options }
    }

    fn all(&self, name: &str) -> &[String] {
        self.options.get(name).map_or(&[], Vec::as_slice)
    }

    fn one(&self, name: &str) -> Option<&str> {
        self.all(name).first().map(String::as_str)
    }

    fn number<T: std::str::FromStr<Err: std::fmt::Debug>>(&self, name: &str) -> Option<T> {
        self.one(name).map(|text| text.parse().unwrap())
    }

    fn doubles<const N: usize>(&self, name: &str) -> Option<[f64; N]> {
        self.one(name).map(doubles)
    }

    fn format(&self, default: Format) -> Format {
        let extension = self.one("o").and_then(|name| name.rsplit('.').next());
        let chosen = self.number("format");
        let chosen = chosen.or_else(|| Format::of_extension(extension?));
        chosen.unwrap_or(default)
    }

    fn fit(&self) -> FitOptions {
        let harmonics = self.number("harmonics").or(self.number("n"));
        let size = harmonics.map(FitSize::Harmonics);
        let size = size.or(self.number("tolerance").map(FitSize::Tolerance));
        let size = size.or(self.number("distance").map(FitSize::Distance));
        let model = match self.one("model") {
            Some("elliptic") => FitModel::Elliptic,
            _ => FitModel::Radius,
        };
        FitOptions::default()
            .model(model)
            .size(size)
            .center(match self.one("center") {
                Some(point) => {
                    let (x, y) = point.split_once(',').unwrap();
                    CenterChoice::Point([x, y].map(|c| c.parse().unwrap()))
                }
                None => CenterChoice::Auto,
            })
            .decimals(self.number("decimals"))
    }

    fn angles(&self, name: &str) -> Vec<Direction> {
        let angles = self.all(name).iter();
        angles.map(|text| text.parse().unwrap()).collect()
    }
}

fn doubles<const N: usize>(text: &str) -> [f64; N] {
    let numbers: Vec<f64> = text.split(',').map(|n| n.parse().unwrap()).collect();
    numbers.try_into().unwrap()
}

/// The words of the commands in the README and the guide, without `stellate`.
fn commands() -> Vec<Vec<String>> {
    let read = |file: &str| fs::read_to_string(root().join(file)).unwrap();
    let all = DOCUMENTATION.map(read).concat();
    let lines = all.lines();
    let commands = lines.filter_map(|line| line.strip_prefix("$ stellate "));
    commands
        .map(|command| shell_words::split(command).unwrap())
        .filter(|words| !["paper", "completions", "man"].contains(&words[0].as_str()))
        .collect()
}

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

/// A folder in which the commands find the files that they name; nothing is written into those.
fn folder() -> TempDir {
    let folder = TempDir::new().unwrap();
    for words in commands() {
        for word in words.iter().filter(|word| word.contains('/')) {
            let from = root().join(word);
            if from.is_file() {
                let to = folder.path().join(word);
                fs::create_dir_all(to.parent().unwrap()).unwrap();
                fs::copy(from, to).unwrap();
            }
        }
    }
    folder
}

/// The form of an argument; files are looked for in the folder.
fn given(folder: &Path, argument: &str, words: &Words) -> Given {
    let path = folder.join(argument);
    let argument = if path.is_file() {
        path.to_str().unwrap()
    } else {
        argument
    };
    let outline = OutlineOptions::default()
        .blob(words.number("blob").unwrap_or(1))
        .columns(words.number("columns"))
        .repair(words.one("repair").is_some());
    let options = ReadOptions::default()
        .outline(outline)
        .cloud(words.one("cloud").is_some());
    Given::read_with(argument, &options, &Work::default()).unwrap()
}

/// What the library makes of a command.
fn by_library(words: &[String], folder: &Path) -> Vec<u8> {
    let (verb, words) = (words[0].as_str(), Words::new(&words[1..]));
    let work = Work::default();
    let first = || given(folder, &words.forms[0], &words);
    let (digits, mut out) = (words.number("digits").unwrap_or(16), Vec::new());
    match verb {
        "fit" if verb::is_mesh_name(&words.forms[0]) => {
            let tolerance = words.fit().tolerance().unwrap();
            let options = MeshFitOptions::new(MeshFitSize::Tolerance(tolerance));
            let solid = verb::read_mesh(&folder.join(&words.forms[0]), &work).unwrap();
            let fit = verb::fit_mesh(&solid, &options, &work).unwrap();
            write_mesh_fit(&fit, words.format(Format::Text), &mut out).unwrap();
        }
        "fit" => {
            let is_normal = words.one("normal-form").is_some();
            let options = words.fit();
            let fits = words.forms.iter().map(|file| {
                let plain = options
                    .clone()
                    .decimals(options.decimals.filter(|_| !is_normal));
                let fit = verb::fit(given(folder, file, &words), &plain, &work).unwrap();
                let fit = match is_normal {
                    true => fit.into_normal_form(options.decimals).unwrap(),
                    false => fit,
                };
                FittedOutline {
                    file: file.clone(),
                    blob: 1,
                    fit,
                }
            });
            let fits: Vec<FittedOutline> = fits.collect();
            match &fits[..] {
                [only] => write_fit(&only.fit, words.format(Format::Text), &mut out).unwrap(),
                all => write_fit_table(all, &mut out).unwrap(),
            }
        }
        "describe" => {
            let options = DescribeOptions::default()
                .fit(words.fit())
                .topology(words.one("topology").is_some());
            let found = verb::describe(first(), &options, &work).unwrap();
            write_described(&found, digits, words.format(Format::Text), &mut out).unwrap();
        }
        "implicitize" => {
            let polar = words.one("method").map(|_| ImplicitizeMethod::Polar);
            let mut options = ImplicitizeOptions::default().fit(words.fit()).method(polar);
            if words.one("scale") == Some("monic") {
                options = options.scale(CoefficientScale::Monic);
            }
            let found = verb::implicitize(first(), &options, &work).unwrap();
            write_implicitization(&found, words.format(Format::Text), &mut out).unwrap();
        }
        "parametrize" => {
            let options = ParametrizeOptions::default()
                .fit(words.fit())
                .thetas(words.angles("theta"))
                .phis(words.angles("phi"));
            let found = verb::parametrize(first(), &options, &work).unwrap();
            write_parametrized(&found, digits, words.format(Format::Text), &mut out).unwrap();
        }
        "sample" => {
            let options = SampleOptions::default()
                .fit(words.fit())
                .directions(words.number("directions"))
                .thetas(words.angles("theta"))
                .phis(words.angles("phi"))
                .positive(words.one("positive").is_some())
                .coordinates(match words.one("coordinates") {
                    Some("original") => CoordinatesFrom::Original,
                    _ => CoordinatesFrom::Center,
                });
            let found = verb::sample(first(), &options, &work).unwrap();
            write_sampled(&found, words.format(Format::Csv), &mut out).unwrap();
        }
        "inspect" => inspected(&words, first(), folder, &mut out),
        "mesh" => {
            let mut options = MeshingOptions::default();
            if let Some(resolution) = words.number("resolution") {
                options = options.resolution(resolution);
            }
            options = options.solid(words.one("solid").is_some());
            let mesh = verb::mesh(first(), &options, &work).unwrap();
            let comment = format!("stellate: {}", first().short_name());
            let extension = words.one("o").unwrap().rsplit('.').next().unwrap();
            let format = MeshFormat::of_extension(extension).unwrap();
            write_mesh(&mesh, &comment, format, &mut out).unwrap();
        }
        "plot" => {
            let frame = |text: &str| match text.split(',').count() {
                4 => {
                    let [x0, x1, y0, y1] = doubles(text);
                    Frame::Plane(Window {
                        x: [x0, x1],
                        y: [y0, y1],
                    })
                }
                _ => {
                    let [x0, x1, y0, y1, z0, z1] = doubles(text);
                    Frame::Space([[x0, x1], [y0, y1], [z0, z1]])
                }
            };
            let mut options = PlotOptions::default()
                .fit(words.fit())
                .window(words.one("window").map(frame))
                .points(words.all("point").iter().map(|p| doubles(p)).collect())
                .title(words.one("title").unwrap_or("").into());
            if let Some(view) = words.doubles("view") {
                options = options.view(Some(view));
            }
            let forms = words.forms.iter().map(|form| given(folder, form, &words));
            let svg = verb::plot(forms.collect(), &options, &work).unwrap();
            let format = FigureFormat::of("-o", Path::new(words.one("o").unwrap())).unwrap();
            out = format.bytes(svg).unwrap();
        }
        "check" if words.one("self").is_some() => {
            let options = verb::CheckOptions::default().fit(words.fit());
            let rungs = verb::check_doubles(first(), &options, &work).unwrap();
            write_ladder(&rungs, Format::Text, &mut out).unwrap();
        }
        "check" => {
            let options = verb::CheckOptions::default().fit(words.fit());
            let task = verb::check(first(), &options, &work).unwrap();
            let name = words.one("coefficients").unwrap();
            let text = fs::read_to_string(folder.join(name)).unwrap();
            let numbers = task.read(FloatKind::Coefficients, &text, name).unwrap();
            let found = task.compare(&numbers, name, &work).unwrap();
            write_check(&found, words.number("digits"), Format::Text, &mut out).unwrap();
        }
        "vectors" => {
            let directions = words.number("directions").unwrap();
            let options = VectorOptions::default().directions(directions);
            let vectors = verb::vectors(first(), &options, &work).unwrap();
            write_vectors(&vectors, &mut out).unwrap();
        }
        "verify" => {
            let text = fs::read_to_string(folder.join(&words.forms[0])).unwrap();
            let report = stellate::proof::check(&text, false).unwrap();
            out.extend(format!("{report}\n").bytes());
        }
        "schema" => out.extend(json_schema(Some(&words.forms[0])).unwrap().bytes()),
        other => panic!("no verb of the library: {other}"),
    }
    out
}

fn inspected(words: &Words, given: Given, folder: &Path, out: &mut Vec<u8>) {
    let work = Work::default();
    let points = match words.one("points") {
        Some(name) => PointSource::Rows(PointRows::open(&folder.join(name)).unwrap()),
        None => PointSource::Texts(words.all("point").to_vec()),
    };
    let dimension = points.dimension().unwrap();
    let zone: ToleranceZone = words.number("tolerance").unwrap();
    let [low, high] = zone.limits().map(Clone::clone);
    let mut options = InspectionOptions::default()
        .tolerance(high)
        .lower(Some(low));
    if let Some(uncertainty) = words.number("uncertainty") {
        options = options.uncertainty(uncertainty);
    }
    let task = verb::inspect(given, dimension, &options, &work).unwrap();
    let format = words.format(Format::Csv);
    let mut writer = InspectionWriter::new(format, dimension, 16).unwrap();
    if words.one("keep").is_some() {
        writer = writer.keeping(points.other_names());
    }
    let with_feet = words.one("feet").is_some();
    if with_feet {
        writer = writer.with_feet();
    }
    let reading = ReadingOptions::default()
        .feet(with_feet)
        .with_ranges(format != Format::Csv);
    task.all(points, &reading, &writer, out, &work).unwrap();
}

#[test]
fn the_library_gives_the_bytes_of_the_program() {
    let folder = folder();
    let commands = commands();
    assert!(commands.len() > 40, "the documentation has its commands");
    for words in &commands {
        let arguments: Vec<&str> = words.iter().map(String::as_str).collect();
        let (run, library) = std::thread::scope(|scope| {
            let library = scope.spawn(|| by_library(words, folder.path()));
            let run = run_in(folder.path(), &arguments, "");
            (run, library.join().unwrap())
        });
        assert!(run.code <= 1, "{words:?}: {}", run.err);
        let file = arguments.iter().position(|word| *word == "-o");
        let program = match file {
            Some(at) => fs::read(folder.path().join(arguments[at + 1])).unwrap(),
            None => run.out.into_bytes(),
        };
        assert!(library == program, "{words:?}");
    }
}

/// A circle of radius 1 whose polynomial is about (10, 0).
fn circle_about_ten() -> ImplicitCurve {
    let text = "# center: 10, 0\nx^2 + y^2 = 1";
    match stellate::language::parse_form(text, "<form>", Numbers::Exact) {
        Ok(Form::Curve(curve)) => curve,
        other => panic!("{other:?}"),
    }
}

#[test]
fn a_center_is_lost_nowhere() {
    let work = Work::default();
    let curve = circle_about_ten();
    let options = InspectionOptions::default().tolerance("1/10".parse().unwrap());
    let task = verb::inspect(Form::Curve(curve.clone()).into(), 2, &options, &work).unwrap();
    let verdict = |x: &str, y: &str| {
        let point = [x, y, "0"].map(|q| q.parse().unwrap());
        let near = stellate::inspect::Inspector::plane(
            &curve,
            &stellate::inspect::InspectorOptions::new("1/10".parse().unwrap()),
            &stellate::limits::Limits::none(),
        );
        let found = task.point(&point);
        assert_eq!(near.unwrap().inspect(&point), found);
        found.verdict
    };
    assert_eq!(verdict("11", "0"), Verdict::Inside);
    assert_eq!(verdict("10.6", "0.8"), Verdict::Inside);
    assert_eq!(verdict("1", "0"), Verdict::Outside);
    assert_eq!(verdict("2.3", "0"), Verdict::Outside);
    // Samples say what they are relative to, and pictures are drawn where the circle is.
    let sampled = verb::sample(
        Form::Curve(curve.clone()).into(),
        &SampleOptions::default().directions(Some(4)),
        &work,
    );
    let verb::SampledPoints::Plane { center, .. } = sampled.unwrap().points else {
        panic!("a curve in the plane");
    };
    assert_eq!(center.map(|c| c.to_string()), ["10", "0"]);
    let frame = |x: [f64; 2]| Frame::Plane(Window { x, y: [-2.0, 2.0] });
    let drawn = |x| {
        let options = PlotOptions::default().window(Some(frame(x)));
        let given: Given = Form::Curve(curve.clone()).into();
        verb::plot(vec![given], &options, &work).unwrap().len()
    };
    assert!(drawn([8.0, 12.0]) > drawn([-2.0, 2.0]) + 1000);
}

#[test]
fn a_coordinate_that_cannot_be_read_exactly_is_refused() {
    for (point, is_good) in [
        ("1e-5000,0", true),
        ("1e-999999999,0", false),
        ("0e999999999,0", false),
        ("0x1p-1074,0", true),
    ] {
        let run = run_in(
            Path::new("."),
            &["inspect", "x + y", "--tolerance", "0.1", "--point", point],
            "",
        );
        assert_eq!(run.code == 0, is_good, "{point}: {}", run.err);
        assert!(
            is_good || run.err.contains("exponent"),
            "{point}: {}",
            run.err
        );
    }
}
