//! Which columns of a table are coordinates, by their names.

use std::collections::BTreeMap;

use crate::rows::Separator;

/// The names of the coordinates of points: those of x, of y and of z. Names of different rows do not belong together.
const FAMILIES: [[&[&str]; 3]; 4] = [
    [&["x"], &["y"], &["z"]],
    [&["px"], &["py"], &["pz"]],
    [&["lon", "long", "longitude"], &["lat", "latitude"], HEIGHTS],
    [&["easting", "east"], &["northing", "north"], HEIGHTS],
];
const HEIGHTS: &[&str] = &["z", "height", "elevation", "altitude", "alt", "up"];

/// Names of columns that are no coordinates of points.
const ANGLES: [&str; 7] = [
    "theta", "angle", "phi", "azimuth", "deg", "degrees", "degree",
];
const RADII: [&str; 4] = ["r", "radius", "rho", "distance"];

/// What may follow the name of a coordinate and says nothing else about it.
const UNITS: [&str; 43] = [
    "px", "pixel", "pixels", "vox", "voxel", "voxels", "pt", "nm", "um", "µm", "μm", "mm", "cm",
    "dm", "m", "km", "in", "inch", "inches", "ft", "foot", "feet", "yd", "mil", "mils", "mi",
    "meter", "meters", "metre", "metres", "micron", "microns", "deg", "degree", "degrees", "rad",
    "arcsec", "arcmin", "mas", "au", "pc", "kpc", "ly",
];

/// The places of coordinates among columns, from 0.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct CoordinatePlaces {
    pub(crate) x: usize,
    pub(crate) y: usize,
    pub(crate) z: Option<usize>,
}

/// The columns that are named as coordinates; `None` if the names say nothing of coordinates, so that a first row of them may be a
/// title.
///
/// The name itself, in any case, comes before the name with a unit, as in `x (mm)` and `x_mm`, and that before a name with something
/// else behind it, which must be the same behind x and y.
///
/// # Errors
/// The message if several columns may be one of the coordinates, if only one of them is named, or if the columns are angles and radii.
pub(crate) fn coordinates_among(names: &[&str]) -> Result<Option<CoordinatePlaces>, String> {
    for [x, y, z] in FAMILIES {
        if let (Some(x), Some(y)) = (any_place_of(names, x), any_place_of(names, y)) {
            let z = any_place_of(names, z).map(Candidates::one).transpose()?;
            return Ok(Some(CoordinatePlaces {
                x: x.one()?,
                y: y.one()?,
                z,
            }));
        }
    }
    for family in FAMILIES {
        if let Some(found) = with_equal_ends(names, family)? {
            return Ok(Some(found));
        }
    }
    let has = |known: &[&str]| any_place_of(names, known).is_some();
    if has(&ANGLES) && has(&RADII) {
        return Err(format!(
            "the columns are angles and radii ({}), not coordinates of points",
            names.join(",")
        ));
    }
    for (k, name) in names.iter().enumerate() {
        let axis = axis_of(name).filter(|axis| *axis != k);
        if let Some(axis) = axis {
            let missing = if axis == 0 { "y" } else { "x" };
            return Err(format!(
                "the first row names {name}, but no column {missing} that belongs to it"
            ));
        }
    }
    Ok(None)
}

/// The columns that the first row of a table names as coordinates, where `fits` says whether it has as many fields as the other rows.
///
/// A row that does not fit is a title, in which words that look like names mean nothing, unless it names coordinates between
/// separators other than blanks: then the other rows have too few fields.
///
/// # Errors
/// Those of [`coordinates_among`] for a row that fits.
pub(crate) fn coordinates_in_first_row(
    names: &[&str],
    separator: Separator,
    fits: bool,
) -> Result<Option<CoordinatePlaces>, String> {
    match coordinates_among(names) {
        found if fits => found,
        Ok(found) if names.len() > 2 && separator != Separator::Blanks => Ok(found),
        Ok(_) | Err(_) => Ok(None),
    }
}

/// The place of the column with this name, or with this name and a unit; the only unit of an angle is the radian.
///
/// # Errors
/// The message if several columns may be it.
pub(crate) fn place_of(names: &[&str], wanted: &str) -> Result<Option<usize>, String> {
    let of_units = |units: &[&str]| places_with_unit(names, &[wanted], units);
    let found = match ANGLES.contains(&wanted) {
        true => of_units(&["rad", "radian", "radians"]),
        false => of_units(&UNITS),
    };
    found.map(Candidates::one).transpose()
}

/// Columns that may be one coordinate, with their names; there is at least one.
struct Candidates<'a>(Vec<(usize, &'a str)>);

impl Candidates<'_> {
    fn one(self) -> Result<usize, String> {
        match self.0[..] {
            [(place, _)] => Ok(place),
            _ => Err(self.unclear()),
        }
    }

    fn unclear(&self) -> String {
        let names = self
            .0
            .iter()
            .map(|(k, name)| format!("{name} (number {})", k + 1));
        let names: Vec<String> = names.collect();
        format!(
            "it is not known which of the columns {} is meant",
            names.join(", ")
        )
    }
}

/// The columns with one of these names; if there are none, those with one of these names and a unit.
fn any_place_of<'a>(names: &[&'a str], known: &[&str]) -> Option<Candidates<'a>> {
    places_with_unit(names, known, &UNITS)
}

fn places_with_unit<'a>(
    names: &[&'a str],
    known: &[&str],
    units: &[&str],
) -> Option<Candidates<'a>> {
    let of_kind = |is_wanted: &dyn Fn(&str) -> bool| {
        let all = names.iter().copied().enumerate();
        let found: Vec<_> = all
            .filter(|(_, name)| end_of(name, known).is_some_and(|end| is_wanted(&end)))
            .collect();
        (!found.is_empty()).then_some(Candidates(found))
    };
    of_kind(&str::is_empty).or_else(|| of_kind(&|end| units.contains(&end)))
}

/// The columns that are named as coordinates with the same end, as in `x_nominal` and `y_nominal`.
fn with_equal_ends(
    names: &[&str],
    family: [&[&str]; 3],
) -> Result<Option<CoordinatePlaces>, String> {
    let mut ends: BTreeMap<String, [Vec<(usize, &str)>; 3]> = BTreeMap::new();
    for (k, name) in names.iter().enumerate() {
        for (axis, known) in family.into_iter().enumerate() {
            if let Some(end) = end_of(name, known) {
                ends.entry(end).or_default()[axis].push((k, name));
            }
        }
    }
    let mut complete = ends
        .into_values()
        .filter(|[x, y, _]| !x.is_empty() && !y.is_empty());
    match (complete.next(), complete.next()) {
        (None, _) => Ok(None),
        (Some([x, y, z]), None) => {
            let z = match z.is_empty() {
                true => any_place_of(names, family[2]),
                false => Some(Candidates(z)),
            };
            Ok(Some(CoordinatePlaces {
                x: Candidates(x).one()?,
                y: Candidates(y).one()?,
                z: z.map(Candidates::one).transpose()?,
            }))
        }
        (Some([first, ..]), Some([second, ..])) => {
            Err(Candidates([first, second].concat()).unclear())
        }
    }
}

/// The number of the coordinate, from 0, of which this is the name; none for heights. The words for directions also name other
/// things, so that only a unit may follow them.
fn axis_of(name: &str) -> Option<usize> {
    (0..2).find(|&axis| {
        FAMILIES.iter().any(|family| {
            let is_letter = family[axis].iter().all(|known| known.len() <= 2);
            end_of(name, family[axis])
                .is_some_and(|end| is_letter || end.is_empty() || UNITS.contains(&end.as_str()))
        })
    })
}

/// What follows one of the known names, in small letters and without the signs around it; `None` for a name of something else.
fn end_of(name: &str, known: &[&str]) -> Option<String> {
    let is_sign = |c: char| !c.is_alphanumeric();
    let small = name.trim_matches(is_sign).to_lowercase();
    let base = small.split(is_sign).next()?;
    let end = small[base.len()..].trim_matches(is_sign);
    known.contains(&base).then(|| end.to_owned())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn found(names: &str) -> Result<Option<(usize, usize, Option<usize>)>, String> {
        let names: Vec<&str> = names.split(',').collect();
        coordinates_among(&names).map(|found| found.map(|p| (p.x, p.y, p.z)))
    }

    #[test]
    fn a_name_comes_before_one_with_more_in_it() {
        for (names, x, y, z) in [
            ("x,y", 0, 1, None),
            ("z,Y,X", 2, 1, Some(0)),
            ("id,x_nom,y_nom,x,y", 3, 4, None),
            ("x [mm],y [mm],x,y", 2, 3, None),
            ("x_err,y_err,x (mm),y (mm)", 2, 3, None),
            ("x-err,y-err,x_px,y_px,z", 2, 3, Some(4)),
            ("lat,x,y", 1, 2, None),
            ("lon,lat,x,y", 2, 3, None),
            ("x_err,y_err,lat,lon", 3, 2, None),
            ("northing,easting,height", 1, 0, Some(2)),
            ("y_nominal,x_nominal", 1, 0, None),
            ("id,X Coordinate,Y Coordinate,Z Coordinate", 1, 2, Some(3)),
            ("x,y,z_err", 0, 1, None),
            ("x_m,y_m,z", 0, 1, Some(2)),
            ("\u{feff}x,\u{b5},y", 0, 2, None),
        ] {
            assert_eq!(found(names), Ok(Some((x, y, z))), "{names}");
        }
        for names in [
            "butterfly",
            "a,b,c",
            "x-ray,outline",
            "x,z",
            "height,weight",
            "short,long name",
        ] {
            assert_eq!(found(names), Ok(None), "{names}");
        }
    }

    #[test]
    fn what_may_be_several_columns_is_refused() {
        for (names, part) in [
            (
                "x_nom,y_nom,x_meas,y_meas",
                "x_meas (number 3), x_nom (number 1)",
            ),
            ("x,y,x", "x (number 1), x (number 3)"),
            ("x (mm),x (in),y", "x (mm) (number 1), x (in) (number 2)"),
            ("theta,r", "angles and radii (theta,r)"),
            ("y,height", "names y, but no column x"),
            ("lat,x", "names lat, but no column x"),
            ("id,x", "names x, but no column y"),
            ("y_meas,x_nom", "names y_meas, but no column x"),
            ("z_a,y_b,x_c", "names x_c, but no column y"),
        ] {
            let message = found(names).unwrap_err();
            assert!(message.contains(part), "{names}: {message}");
        }
        assert_eq!(place_of(&["r_err", "R (mm)"], "r"), Ok(Some(1)));
        assert_eq!(place_of(&["r_err"], "r"), Ok(None));
        assert_eq!(place_of(&["theta (deg)"], "theta"), Ok(None));
        assert_eq!(place_of(&["theta_rad"], "theta"), Ok(Some(0)));
        assert!(place_of(&["r", "r"], "r").is_err());
    }
}
