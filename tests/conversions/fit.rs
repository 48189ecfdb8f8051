//! Outlines from files to Fourier radii: the stand-ins for the paper's Example 2.

use std::fs;
use std::path::Path;

use stellate::error::{Error, Result};
use stellate::fit::{
    Center, CenterChoice, CenterOrigin, ContourRadius, Fit, FitOptions, FitSize, fit, read_contour,
};
use stellate::shape::{Contour, FourierRadius};

fn outline(folder: &str, name: &str) -> Contour {
    let examples = Path::new(env!("CARGO_MANIFEST_DIR")).join("paper-examples");
    read_contour(&examples.join(folder).join(name)).expect("the example is readable")
}

fn butterfly() -> Contour {
    outline("e02-butterfly", "butterfly.csv")
}

fn jet() -> Contour {
    outline("e02-jet", "jet.csv")
}

fn fitted(contour: &Contour, size: FitSize) -> Fit {
    fit(contour, &FitOptions::new(size)).expect("the outline can be fitted")
}

/// `a_n` and `b_n` over `a_0`, which do not depend on the size of the outline.
fn relative(radius: &FourierRadius, n: usize) -> [f64; 2] {
    let a0 = radius.cos(0).to_f64();
    [radius.cos(n).to_f64() / a0, radius.sin(n).to_f64() / a0]
}

fn from_text(name: &str, text: &str) -> Result<Contour> {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let path = folder.path().join(name);
    fs::write(&path, text).expect("a writable temporary folder");
    read_contour(&path)
}

#[test]
fn example_2_the_butterfly_is_star_shaped_about_its_centroid() {
    let contour = butterfly();
    assert_eq!(contour.len(), 289);
    let fit = fitted(&contour, FitSize::Harmonics(39));
    assert_eq!(fit.center.origin, CenterOrigin::Centroid);
    let seen = fit.outline.unwrap();
    assert!(seen.star_shaped);
    assert!(seen.hidden_share <= 0.0);
    assert_eq!((fit.radius.harmonics(), fit.samples), (39, 1024));
    // N = 39 gives Example 2's degree 80; the fit is good to 6.6 % of the mean radius, 0.85 % rms.
    let a0 = fit.radius.cos(0).to_f64();
    assert!((fit.max_radial_error / a0 - 0.066_08).abs() < 1e-4);
    assert!((fit.rms_radial_error / a0 - 0.008_488).abs() < 1e-5);
}

#[test]
fn example_2_the_jet_is_not_star_shaped_about_its_centroid() {
    let contour = jet();
    let center = Center::choose(&contour, &CenterChoice::Auto, None).unwrap();
    assert_eq!(center.origin, CenterOrigin::Centroid);
    assert_eq!(center.star_shaped, Some(false));
    let radius = ContourRadius::new(&contour, center.point).unwrap();
    // It has no kernel to move to. Parts of the wings and of the tail hide 15.8 % of the outline.
    assert!((radius.hidden_share() - 0.157_928).abs() < 1e-5);
    assert!((radius.largest_jump().0 - 460.724).abs() < 1e-2);
    let fit = fitted(&contour, FitSize::Harmonics(39));
    assert!(!fit.outline.unwrap().star_shaped);
    // A series leaves at least half of each jump.
    assert!(fit.max_radial_error >= radius.largest_jump().0 / 2.0);
    let error = stellate::fit::fit(&contour, &FitOptions::new(FitSize::Tolerance(10.0)));
    assert!(matches!(error, Err(Error::Limit { .. })));
}

#[test]
fn rows_and_pictures_of_one_outline_give_one_fit() {
    for (folder, name) in [("e02-butterfly", "butterfly"), ("e02-jet", "jet")] {
        let rows = outline(folder, &format!("{name}.csv"));
        let picture = outline(folder, &format!("{name}.png"));
        let [rows_low, rows_high] = rows.bounding_box();
        let [low, high] = picture.bounding_box();
        let scale = (high[0] - low[0]) / (rows_high[0] - rows_low[0]);
        // The pictures are 512 pixels wide: areas agree to a few pixels along the border.
        let ratio = picture.area() / (rows.area() * scale * scale);
        assert!(
            (ratio - 1.0).abs() < 0.02,
            "{name}: areas differ by {ratio}"
        );
        // The picture's center in the coordinates of the rows.
        let centroid = rows.centroid();
        let center: Vec<f64> = (0..2)
            .map(|k| rows_low[k] + (picture.centroid()[k] - low[k]) / scale)
            .collect();
        assert!((center[0] - centroid[0]).abs() < 1.0 / scale, "{name}");
        assert!((center[1] - centroid[1]).abs() < 1.0 / scale, "{name}");
        let rows = fitted(&rows, FitSize::Harmonics(20)).radius;
        let picture = fitted(&picture, FitSize::Harmonics(20)).radius;
        let a0 = picture.cos(0).to_f64() / (rows.cos(0).to_f64() * scale);
        assert!((a0 - 1.0).abs() < 0.01, "{name}: mean radii differ by {a0}");
        for n in 1..=20 {
            let (of_rows, of_picture) = (relative(&rows, n), relative(&picture, n));
            for k in 0..2 {
                let difference = (of_rows[k] - of_picture[k]).abs();
                assert!(difference < 0.01, "{name}, harmonic {n}: {difference}");
            }
        }
    }
}

#[test]
fn the_fewest_harmonics_within_two_percent_are_found() {
    let contour = butterfly();
    let a0 = fitted(&contour, FitSize::Harmonics(0))
        .radius
        .cos(0)
        .to_f64();
    let tolerance = 0.02 * a0;
    let fit = fitted(&contour, FitSize::Tolerance(tolerance));
    assert_eq!(fit.radius.harmonics(), 115);
    assert!(fit.max_radial_error <= tolerance);
    // One fewer does not do, nor any other smaller number.
    for n in 0..115 {
        let options = FitOptions::new(FitSize::Harmonics(n)).samples(Some(fit.samples));
        let fewer = stellate::fit::fit(&contour, &options).unwrap();
        assert!(fewer.max_radial_error > tolerance, "{n} harmonics would do");
    }
}

#[test]
fn bad_files_are_diagnosed_by_name_and_row() {
    let message = |text: &str| from_text("outline.csv", text).unwrap_err().to_string();
    assert!(
        message("x,y\n0,0\n1,abc\n")
            .ends_with("outline.csv, row 3: \"abc\" is not a number; each row must be x,y")
    );
    assert!(
        message("0,0\n1,1\n")
            .ends_with("outline.csv: an outline needs at least three points; there are two")
    );
    assert!(message("0,0\n1,1\n2,2\n3,3\n").contains("all points lie on one line"));
    assert!(message("# bow tie\n0,0\n2,2\n\n2,0\n0,2\n").ends_with(
        "outline.csv: the outline crosses or touches itself: the edge from row 2 to row 3 meets the \
         edge from row 5 to row 6 near (1.000000, 1.000000); --repair cuts such loops off"
    ));
    assert!(from_text("outline.png", "x").is_err());
    assert!(from_text("outline.txt", "0,0\n1,0\n0,1\n").is_err());
}
