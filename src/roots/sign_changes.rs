//! Changes of sign of a list of numbers, some of which may have an unknown sign.

/// The number of sign changes of a list; zeros do not count.
pub(crate) fn sign_changes(signs: impl Iterator<Item = i8>) -> usize {
    let mut last = 0;
    let mut changes = 0;
    for s in signs.filter(|&s| s != 0) {
        changes += usize::from(last == -s);
        last = s;
    }
    changes
}

/// The number of sign changes, as far as Descartes' rule needs it.
pub(super) enum Changes {
    None,
    One,
    More,
}

impl Changes {
    /// The number of sign changes of a list in which unknown signs may be anything. `None` and `One` are
    /// certain; `More` means two or more, or not known.
    pub(super) fn count(signs: impl Iterator<Item = Option<i8>>) -> Self {
        let mut last: Option<i8> = None;
        let mut unknown = 0;
        let mut changes = 0;
        for s in signs {
            let Some(s) = s else {
                unknown += 1;
                continue;
            };
            match last {
                None if unknown > 0 => return Self::More,
                Some(l) if l == s && unknown > 0 => return Self::More,
                Some(l) if l != s && unknown > 1 => return Self::More,
                Some(l) => changes += usize::from(l != s),
                None => {}
            }
            (last, unknown) = (Some(s), 0);
        }
        match (unknown, changes) {
            (0, 0) => Self::None,
            (0, 1) => Self::One,
            _ => Self::More,
        }
    }
}
