//! The sheet that all pictures share: title, conditions and statement above, body, legend below.

use plotters::coord::Shift;
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};

use crate::caption::Caption;
use crate::figure_error::{FigureError, drawing};
use crate::ink;

/// A part of a picture.
pub type Sheet<'b> = DrawingArea<SVGBackend<'b>, Shift>;

/// Height of the part under the body, pixels.
const FOOT: u32 = 34;

/// Writes the head of a picture of `size` and returns its body and its foot.
pub fn parts<'b>(
    sheet: &Sheet<'b>,
    (width, height): (u32, u32),
    caption: &Caption,
) -> Result<(Sheet<'b>, Sheet<'b>), FigureError> {
    sheet.fill(&WHITE).map_err(drawing)?;
    let head = if caption.statement.is_some() { 86 } else { 64 };
    let (top, rest) = sheet.split_vertically(head);
    let centred = Pos::new(HPos::Center, VPos::Center);
    let statement = caption.statement.clone().unwrap_or_default();
    let lines = [
        (&caption.title, 26, ink::text(18, ink::TEXT)),
        (&caption.conditions, 50, ink::text(12, ink::PALE_TEXT)),
        (&statement, 70, ink::text(12, ink::STATEMENT)),
    ];
    for (text, y, style) in lines {
        if !text.is_empty() {
            let place = (width as i32 / 2, y);
            top.draw(&Text::new(text.clone(), place, style.pos(centred)))
                .map_err(drawing)?;
        }
    }
    Ok(rest.split_vertically(height - head as u32 - FOOT))
}

/// Sets the letters of V_H and V_V as subscripts, which the drawing library cannot.
pub fn with_subscripts(svg: &str) -> String {
    let mut set = String::with_capacity(svg.len());
    let mut rest = svg;
    while let Some(start) = rest.find("V_") {
        let (before, symbol) = rest.split_at(start);
        set += before;
        let after = &symbol[2..];
        let mut letters = after.chars();
        let (index, next) = (letters.next(), letters.next());
        match index {
            Some(index @ ('H' | 'V')) => {
                set += &format!("V<tspan dy=\"3\" font-size=\"75%\">{index}</tspan>");
                // The base line comes back with the next letter, if there is one.
                let used = next.filter(|letter| !matches!(letter, '\n' | '<' | '&'));
                if let Some(letter) = used {
                    set += &format!("<tspan dy=\"-3\">{letter}</tspan>");
                }
                rest = &after[1 + used.map_or(0, char::len_utf8)..];
            }
            _ => {
                set += "V_";
                rest = after;
            }
        }
    }
    set + rest
}

/// Round values between two ends, about six of them, the ends included where they are round.
pub fn round_values(from: f64, to: f64) -> Vec<f64> {
    let rough = (to - from) / 6.0;
    let power = 10f64.powf(rough.log10().floor());
    let step = [1.0, 2.0, 5.0, 10.0]
        .into_iter()
        .map(|factor| factor * power)
        .find(|step| *step >= rough * 0.999)
        .unwrap_or(rough);
    let first = (from / step - 1e-9).ceil() as i64;
    let last = (to / step + 1e-9).floor() as i64;
    (first..=last).map(|index| index as f64 * step).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn round_values_lie_between_the_ends() {
        assert_eq!(
            round_values(80.0, 180.0),
            [80.0, 100.0, 120.0, 140.0, 160.0, 180.0]
        );
        assert_eq!(round_values(-60.0, 60.0).len(), 7);
        assert_eq!(
            with_subscripts("<text>\nV_H, V_V\n"),
            "<text>\nV<tspan dy=\"3\" \
            font-size=\"75%\">H</tspan><tspan dy=\"-3\">,</tspan> V<tspan dy=\"3\" \
            font-size=\"75%\">V</tspan>\n"
        );
    }
}
