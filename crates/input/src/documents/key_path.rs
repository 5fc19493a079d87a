//! Dotted keys such as `legs[2].strut.preload_lb`: nested tables, with array entries counted from 1.

/// A dotted key.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct KeyPath {
    pub(crate) steps: Vec<Step>,
}

/// One key of a path.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Step {
    pub(crate) key: String,
    /// Index of an array entry, from 0, if given.
    pub(crate) entry: Option<usize>,
}

impl KeyPath {
    /// Parses a dotted key; `None` if it is not of that form.
    pub fn parse(dotted: &str) -> Option<Self> {
        let steps = dotted.split('.').map(step).collect::<Option<_>>()?;
        Some(Self { steps })
    }

    /// The same key for all legs, if it is one leg's own.
    pub(crate) fn of_all_legs(&self) -> Option<Self> {
        let (first, rest) = self.steps.split_first()?;
        (first.key == "legs" && first.entry.is_some()).then(|| Self {
            steps: rest.to_vec(),
        })
    }
}

fn step(text: &str) -> Option<Step> {
    let (key, entry) = match text.split_once('[') {
        None => (text, None),
        Some((key, rest)) => {
            let number: usize = rest.strip_suffix(']')?.parse().ok()?;
            (key, Some(number.checked_sub(1)?))
        }
    };
    (!key.is_empty()).then(|| Step {
        key: key.to_owned(),
        entry,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn entries_are_counted_from_one() {
        let path = KeyPath::parse("legs[2].strut.preload_lb").unwrap();
        assert_eq!(path.steps.len(), 3);
        assert_eq!(
            (path.steps[0].key.as_str(), path.steps[0].entry),
            ("legs", Some(1))
        );
        assert_eq!(path.steps[2].entry, None);
    }

    #[test]
    fn what_is_no_dotted_key_is_none() {
        for text in ["", "a..b", "legs[0]", "legs[x].a", "legs[1", ".a", "[1]"] {
            assert_eq!(KeyPath::parse(text), None, "{text}");
        }
    }
}
