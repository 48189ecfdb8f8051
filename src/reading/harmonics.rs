//! Files of spherical-harmonic coefficients are read.

use std::collections::BTreeMap;

use super::norm::{Norm, Normalization, Rounded, rounded_product};
use super::table::read_center;
use crate::error::{Error, Result};
use crate::exact::Rational;
use crate::language::{Numbers, check_size, number_at};
use crate::options::options;
use crate::rows::words;
use crate::shape::{HarmonicSurface, MAX_HARMONIC_DEGREE};

/// How the rows of a file of harmonics are laid out.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum HarmonicLayout {
    /// Degree, order ≥ 0, and the coefficients of the cosine and of the sine, `l m C S`, as SHTOOLS and SHADR write them. Further columns, of
    /// errors, are left out, and so is a first row with the constants of a planet.
    Real,
    /// Degree, order of either sign, and the real and the imaginary part of a coefficient, `n m Re Im`.
    Complex,
    /// Degree, order and coefficient, `l,m,value`; an order below 0 is that of a sine.
    Long,
}

options! {
    /// The convention of a file of harmonics.
    HarmonicConvention {
        /// The normalisation; by default that of the layout.
        normalization: Option<Normalization> = None,
        /// Whether the harmonics have the Condon–Shortley phase (−1)^m; by default as in the layout.
        condon_shortley: Option<bool> = None,
    }
}

impl HarmonicConvention {
    /// Whether nothing is said.
    pub(crate) fn is_default(&self) -> bool {
        self.normalization.is_none() && self.condon_shortley.is_none()
    }
}

/// A harmonic surface, and how its file was understood.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct ReadHarmonics {
    /// The surface; [`HarmonicSurface::rounding`] bounds what was rounded.
    pub surface: HarmonicSurface,
    /// The layout of the rows.
    pub layout: HarmonicLayout,
    /// The normalisation.
    pub normalization: Normalization,
    /// Whether there is a Condon–Shortley phase.
    pub condon_shortley: bool,
}

/// The layout that the names of the columns say, in lower case; `None` if they are not those of harmonics.
pub(crate) fn layout_of_header(names: &[&str]) -> Option<HarmonicLayout> {
    let [l, m, rest @ ..] = names else {
        return None;
    };
    let is_index = ["l", "n", "degree"].contains(l) && ["m", "order"].contains(m);
    match rest {
        ["value" | "coefficient"] if is_index => Some(HarmonicLayout::Long),
        ["re" | "real", "im" | "imag" | "imaginary"] if is_index => Some(HarmonicLayout::Complex),
        ["c" | "clm" | "cnm" | "g", "s" | "slm" | "snm" | "h", ..] if is_index => {
            Some(HarmonicLayout::Real)
        }
        _ => None,
    }
}

/// Reads the coefficients of a harmonic surface. Rows are separated by commas, semicolons, tabs or blanks; `#` starts a comment,
/// of which `# center: p/q, p/q, p/q` gives the center, and a first row of names says the layout where it is not given.
///
/// The convention is that of the layout unless another is given: `l m C S` is 4π-normalised without the Condon–Shortley phase,
/// `n m Re Im` orthonormal with it, and `l,m,value` unnormalised without it. Where a normalisation is irrational, every coefficient
/// times its norm is rounded to a dyadic number such that the radius is off by at most 2^(−60) of its mean in every direction.
///
/// ```
/// use stellate::language::Numbers;
/// use stellate::reading::{HarmonicConvention, HarmonicLayout, Normalization, read_harmonics};
/// let text = "l,m,value\n0,0,10\n2,0,1/3\n3,-2,-0.1\n";
/// let read = read_harmonics(text, "a.csv", None, &HarmonicConvention::default(), Numbers::Exact)?;
/// assert_eq!(read.layout, HarmonicLayout::Long);
/// assert_eq!(read.normalization, Normalization::Unnormalized);
/// assert_eq!(read.surface.coefficient(3, -2).to_string(), "-1/10");
/// # Ok::<(), stellate::error::Error>(())
/// ```
///
/// # Errors
/// [`Error::Data`] with the line for a row that is cut, an order beyond its degree, a number that is none, or a pair that is given twice;
/// for complex coefficients that are not those of a real radius; [`Error::Limit`] beyond [`MAX_HARMONIC_DEGREE`].
pub fn read_harmonics(
    text: &str,
    source_name: &str,
    layout: Option<HarmonicLayout>,
    convention: &HarmonicConvention,
    numbers: Numbers,
) -> Result<ReadHarmonics> {
    check_size(text, source_name)?;
    let rows = Rows::read(text, source_name, layout, numbers)?;
    rows.check_complete(source_name)?;
    let layout = rows.layout;
    let default = match layout {
        HarmonicLayout::Real if rows.is_unnormalized => (Normalization::Unnormalized, false),
        HarmonicLayout::Real => (Normalization::FourPi, false),
        HarmonicLayout::Complex => (Normalization::Orthonormal, true),
        HarmonicLayout::Long => (Normalization::Unnormalized, false),
    };
    let normalization = convention.normalization.unwrap_or(default.0);
    let condon_shortley = convention.condon_shortley.unwrap_or(default.1);
    let terms = rows.terms(condon_shortley, source_name)?;
    let norm = Norm {
        normalization,
        is_complex: layout == HarmonicLayout::Complex,
    };
    let Rounded { terms, bound } = rounded_product(terms, norm);
    let mut surface = HarmonicSurface::new(terms)?.with_rounding(bound);
    if let Some(center) = read_center(text, source_name, numbers)? {
        let center = center.in_space();
        surface = surface.with_center(center.map_err(|message| Error::data(source_name, message))?);
    }
    if surface.is_zero() {
        return Err(Error::data(source_name, "every coefficient is 0"));
    }
    Ok(ReadHarmonics {
        surface,
        layout,
        normalization,
        condon_shortley,
    })
}

/// The rows of a file by degree and order, each with its line and one or two numbers.
struct Rows {
    layout: HarmonicLayout,
    /// Whether the header of an SHADR file says so.
    is_unnormalized: bool,
    values: BTreeMap<(usize, isize), (usize, [Rational; 2])>,
}

impl Rows {
    fn read(
        text: &str,
        source_name: &str,
        layout: Option<HarmonicLayout>,
        numbers: Numbers,
    ) -> Result<Self> {
        let mut lines = text
            .trim_start_matches('\u{feff}')
            .lines()
            .enumerate()
            .map(|(n, line)| (n + 1, line.split('#').next().unwrap_or("").trim()))
            .filter(|(_, line)| !line.is_empty())
            .peekable();
        let (mut layout, mut is_unnormalized) = (layout, false);
        if let Some((_, first)) = lines.peek() {
            let fields: Vec<String> = words(first).map(str::to_ascii_lowercase).collect();
            let names: Vec<&str> = fields.iter().map(String::as_str).collect();
            if names
                .first()
                .is_some_and(|name| name.starts_with(char::is_alphabetic))
            {
                layout = layout_of_header(&names).or(layout);
                lines.next();
            } else if names.len() >= 6 && names[0].parse::<u32>().is_err() {
                // The reference radius, GM, its uncertainty, the degree, the order, and 1 for normalised coefficients.
                is_unnormalized = names[5].parse() == Ok(0);
                lines.next();
            }
        }
        let layout = layout.unwrap_or(HarmonicLayout::Real);
        let mut rows = Self {
            layout,
            is_unnormalized,
            values: BTreeMap::new(),
        };
        for (line, row) in lines {
            rows.add(&format!("{source_name}:{line}"), line, row, numbers)?;
        }
        if rows.values.is_empty() {
            return Err(Error::data(source_name, "there are no coefficients"));
        }
        Ok(rows)
    }

    fn add(&mut self, place: &str, line: usize, row: &str, numbers: Numbers) -> Result<()> {
        let wrong = |message: String| Err(Error::data(place, message));
        let fields: Vec<&str> = words(row).collect();
        let (columns, width) = match self.layout {
            HarmonicLayout::Real => ("l m C S", 4),
            HarmonicLayout::Complex => ("n m Re Im", 4),
            HarmonicLayout::Long => ("l,m,value", 3),
        };
        let more = self.layout == HarmonicLayout::Real && [5, 6].contains(&fields.len());
        if fields.len() != width && !more {
            return wrong(format!(
                "expected the {width} columns {columns}, found {} fields; is the file cut off here?",
                fields.len()
            ));
        }
        let Ok(l) = fields[0].parse::<usize>() else {
            return wrong(format!(
                "the degree `{}` is no whole number from 0 on",
                fields[0]
            ));
        };
        if l > MAX_HARMONIC_DEGREE {
            return Err(Error::limit(format!(
                "{place}: a harmonic of a degree beyond {MAX_HARMONIC_DEGREE}"
            )));
        }
        let Ok(m) = fields[1].parse::<isize>() else {
            return wrong(format!("the order `{}` is no whole number", fields[1]));
        };
        if m.unsigned_abs() > l {
            return wrong(format!(
                "the order {m} is beyond the degree {l}: an order is between -l and l; are the columns exchanged?"
            ));
        }
        if m < 0 && self.layout == HarmonicLayout::Real {
            return wrong(format!(
                "the order {m} of a row {columns} is negative: C and S are the coefficients of cos and sin"
            ));
        }
        let number = |field: &str| {
            // Fortran writes exponents with D.
            let text = field.replace(['D', 'd'], "e");
            number_at(place, &text, numbers)
        };
        let first = number(fields[2])?;
        let second = match self.layout {
            HarmonicLayout::Long => Rational::zero(),
            _ => number(fields[3])?,
        };
        if m == 0 && !second.is_zero() {
            return wrong(match self.layout {
                HarmonicLayout::Complex => "the imaginary part for m = 0 is not 0: these are no coefficients of a real radius".into(),
                _ => "S for m = 0 is not 0: there is no such harmonic".into(),
            });
        }
        if let Some((before, _)) = self.values.insert((l, m), (line, [first, second])) {
            return wrong(format!(
                "degree {l}, order {m} was given before, in line {before}"
            ));
        }
        Ok(())
    }

    /// Refuses a file with rows `l m C S` or `n m Re Im` that ends within a degree, after complete ones.
    fn check_complete(&self, source_name: &str) -> Result<()> {
        let least = |l: usize| match self.layout {
            HarmonicLayout::Complex if self.values.keys().any(|(_, m)| *m < 0) => -l.cast_signed(),
            _ => 0,
        };
        if self.layout == HarmonicLayout::Long {
            return Ok(());
        }
        let missing = |l: usize| -> Vec<isize> {
            let all = least(l)..=l.cast_signed();
            all.filter(|m| !self.values.contains_key(&(l, *m)))
                .collect()
        };
        let degrees = self.values.keys().map(|(l, _)| *l);
        let (Some(first), Some(last)) = (degrees.clone().min(), degrees.max()) else {
            return Ok(());
        };
        let of_last = missing(last);
        let is_cut = last > first && (first..last).all(|l| missing(l).is_empty());
        match of_last.first() {
            Some(order) if is_cut => Err(Error::data(
                source_name,
                format!(
                    "degree {last} lacks {} of its orders, the first is {order}, and all degrees below are complete: the file is cut off",
                    of_last.len()
                ),
            )),
            _ => Ok(()),
        }
    }

    /// The coefficients of cos mθ (m ≥ 0) and sin |m|θ (m < 0) in the normalisation of the file, without the phase.
    fn terms(
        &self,
        condon_shortley: bool,
        source_name: &str,
    ) -> Result<Vec<((usize, isize), Rational)>> {
        let mut terms = Vec::new();
        for (&(l, m), (line, [first, second])) in &self.values {
            let negative = condon_shortley && m % 2 != 0;
            let signed = |c: Rational| if negative { -c } else { c };
            match self.layout {
                HarmonicLayout::Long => terms.push(((l, m), signed(first.clone()))),
                HarmonicLayout::Real => {
                    terms.push(((l, m), signed(first.clone())));
                    if m > 0 {
                        terms.push(((l, -m), signed(second.clone())));
                    }
                }
                HarmonicLayout::Complex if m < 0 => {
                    let is_conjugate = self.values.get(&(l, -m)).is_some_and(|(_, [re, im])| {
                        signed(re.clone()) == *first && signed(-im) == *second
                    });
                    if !is_conjugate {
                        let relation = if condon_shortley {
                            "(-1)^m conj a(n, m)"
                        } else {
                            "conj a(n, m)"
                        };
                        let message = format!(
                            "a({l}, {m}) is not the one of a real radius, for which a(n, -m) = {relation}; is --condon-shortley right?"
                        );
                        return Err(Error::data(format!("{source_name}:{line}"), message));
                    }
                }
                HarmonicLayout::Complex if m == 0 => terms.push(((l, 0), first.clone())),
                HarmonicLayout::Complex => {
                    // The sum of the terms of m and −m is 2 Re(a Y).
                    let two = Rational::from(2);
                    terms.push(((l, m), signed(first * &two)));
                    terms.push(((l, -m), signed(-(second * &two))));
                }
            }
        }
        Ok(terms)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(text: &str, layout: HarmonicLayout) -> Result<ReadHarmonics> {
        let convention = HarmonicConvention::default();
        read_harmonics(text, "a", Some(layout), &convention, Numbers::Exact)
    }

    /// A complex and a real file of one surface, worked out by hand: Y_1^1 of the orthonormal kind is −√(3/8π) sin φ e^{iθ}.
    #[test]
    fn layouts_agree() {
        let complex = "0 0 10 0\n1 1 -1 2\n1 0 3 0\n1 -1 1 2\n";
        let complex = read(complex, HarmonicLayout::Complex).unwrap().surface;
        // 10/√4π + 3 √(3/4π) cos φ + √(3/8π) sin φ (2 cos θ + 4 sin θ)
        let expected = [
            (0, 0, 10.0 / (4.0 * std::f64::consts::PI).sqrt()),
            (1, 0, 3.0 * (3.0 / (4.0 * std::f64::consts::PI)).sqrt()),
            (1, 1, 2.0 * (3.0 / (8.0 * std::f64::consts::PI)).sqrt()),
            (1, -1, 4.0 * (3.0 / (8.0 * std::f64::consts::PI)).sqrt()),
        ];
        for (l, m, value) in expected {
            let found = complex.coefficient(l, m).to_f64();
            assert!(
                (found - value).abs() < 1e-15 * 10.0,
                "{l} {m}: {found} {value}"
            );
        }
        let bound = complex.rounding().to_f64() / complex.coefficient(0, 0).to_f64();
        assert!(bound > 0.0 && bound <= 2f64.powi(-60), "{bound}");
    }

    #[test]
    fn real_rows_are_4_pi_normalized() {
        let surface = read("0,0,2,0\n1,0,1,0\n1,1,1,-1\n", HarmonicLayout::Real)
            .unwrap()
            .surface;
        assert_eq!(surface.coefficient(0, 0).to_string(), "2");
        assert!((surface.coefficient(1, 0).to_f64() - 3f64.sqrt()).abs() < 1e-15);
        assert!((surface.coefficient(1, -1).to_f64() + 3f64.sqrt()).abs() < 1e-15);
    }

    #[test]
    fn bad_files_are_refused_in_one_sentence() {
        use HarmonicLayout::{Complex, Long, Real};
        for (text, layout, part) in [
            (
                "0 0 1 0\n1 0 1",
                Real,
                "a:2: expected the 4 columns l m C S, found 3 fields",
            ),
            (
                "0 0 1 0\n1 2 1 0\n",
                Real,
                "the order 2 is beyond the degree 1",
            ),
            ("0 0 NaN 0\n", Real, "a:1"),
            ("0 0 1 0\n1 0 1 0\n", Real, "degree 1 lacks 1 of its orders"),
            ("0 0 1 0\n0 0 1 0\n", Real, "was given before, in line 1"),
            ("0 0 1 1\n", Real, "S for m = 0"),
            ("0 0 1 0\n1 -1 1 0\n", Real, "is negative"),
            (
                "0 0 1 0\n1 1 1 2\n1 0 0 0\n1 -1 1 2\n",
                Complex,
                "is not the one of a real radius",
            ),
            ("l,m,value\n0,0\n", Long, "a:2: expected the 3 columns"),
            ("l,m,value\n", Long, "there are no coefficients"),
            ("0,0,0\n", Long, "every coefficient is 0"),
            ("x 0 1 0\n", Real, "there are no coefficients"),
            ("0 0 1 0\nx 0 1 0\n", Real, "the degree `x`"),
        ] {
            let error = read(text, layout).expect_err(text).to_string();
            assert!(error.contains(part), "{text}: {error}");
        }
    }
}
