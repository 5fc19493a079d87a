//! Colours, fills and outlines.

/// A colour: red, green and blue.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Colour(pub u8, pub u8, pub u8);

impl Colour {
    /// In SVG notation.
    pub fn hex(self) -> String {
        let Self(r, g, b) = self;
        format!("#{r:02X}{g:02X}{b:02X}")
    }
}

/// White.
pub const WHITE: Colour = Colour(255, 255, 255);

/// Fill and outline of a shape.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Style {
    fill: Option<Colour>,
    stroke: Option<(Colour, f64)>,
    dashes: Option<(f64, f64)>,
    opacity: Option<f64>,
}

impl Style {
    /// Filled, without an outline.
    pub fn fill(colour: Colour) -> Self {
        Self {
            fill: Some(colour),
            ..Self::default()
        }
    }

    /// Outlined by a line of a width in pixels, not filled.
    pub fn stroke(colour: Colour, width: f64) -> Self {
        Self::default().outlined(colour, width)
    }

    /// With an outline of a width in pixels.
    pub fn outlined(self, colour: Colour, width: f64) -> Self {
        Self {
            stroke: Some((colour, width)),
            ..self
        }
    }

    /// With a broken outline: lengths of a dash and of a gap, pixels.
    pub fn dashed(self, dashes: Option<(f64, f64)>) -> Self {
        Self { dashes, ..self }
    }

    /// Transparent: 0 is invisible, 1 opaque.
    pub fn opacity(self, opacity: f64) -> Self {
        Self {
            opacity: Some(opacity),
            ..self
        }
    }

    /// As attributes of an SVG element.
    pub fn attributes(&self) -> String {
        let mut text = match self.fill {
            Some(colour) => format!(" fill=\"{}\"", colour.hex()),
            None => " fill=\"none\"".to_owned(),
        };
        if let Some((colour, width)) = self.stroke {
            text += &format!(" stroke=\"{}\" stroke-width=\"{width}\"", colour.hex());
        }
        if let Some((dash, gap)) = self.dashes {
            text += &format!(" stroke-dasharray=\"{dash} {gap}\"");
        }
        if let Some(opacity) = self.opacity {
            text += &format!(" opacity=\"{opacity}\"");
        }
        text
    }
}
