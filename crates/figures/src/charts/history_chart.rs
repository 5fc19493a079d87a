//! Histories of landings: panels over the same time, several curves in each.

use crate::axis_title::axis_title;
use crate::canvas::{Canvas, Point};
use crate::caption::Caption;
use crate::frame::{Area, Frame, Scale};
use crate::history_page::{self, Curve, Panel};
use crate::history_table::{History, HistoryTable, Instant};
use crate::legend::{self, Entry, Mark};
use crate::palette;
use crate::sheet::{self, Height, Sheet};
use crate::style::Style;
use crate::ticks::round_values;
use crate::unit::in_si;
use crate::words::FigureError;
use crate::words::label;

/// Width of the picture, and height of its panels if they are few and if they are many, pixels.
const WIDTH: f64 = 900.0;
const PANEL: f64 = 285.0;
const LOW_PANEL: f64 = 200.0;
/// Number of panels above which they are low.
const FEW: usize = 3;
/// Space at the top of a panel for a row of its legend, pixels.
const LEGEND: f64 = 22.0;
/// Widths of lines in contact and in free flight, pixels.
const CONTACT: f64 = 1.8;
const FREE: f64 = 4.0;

/// Draws histories of one or several named tables as SVG: the panels by which a landing is judged, or chosen columns.
/// Lines are thick in free flight; printed values are circles.
///
/// # Errors
/// When no table has a chosen column, or tables have a quantity in different units.
pub fn draw(
    tables: &[(String, HistoryTable)],
    columns: &[String],
    caption: &Caption,
) -> Result<String, FigureError> {
    let mut quantities: Vec<String> = Vec::new();
    for name in tables.iter().flat_map(|(_, table)| &table.quantities) {
        if !quantities.contains(name) {
            quantities.push(name.clone());
        }
    }
    let other = |name: &String| in_si(name).filter(|other| quantities.contains(other));
    if let Some(other) = quantities.iter().find_map(other) {
        return Err(FigureError::Table(format!(
            "{other} and the same in other units: expected histories in the same units"
        )));
    }
    let panels = match columns {
        [] => history_page::panels(&quantities),
        names => history_page::chosen(&quantities, names)?,
    };
    let landings = landings(tables);
    let chart = Chart {
        // Colours distinguish curves if panels have several, else landings.
        are_curves_coloured: panels.iter().any(|panel| panel.curves.len() > 1),
        end: tables
            .iter()
            .map(|(_, table)| table.end())
            .fold(0.0, f64::max),
        landings,
    };
    let height = if panels.len() > FEW { LOW_PANEL } else { PANEL };
    let height = Height::Body(height * panels.len() as f64);
    let Sheet { mut canvas, body } = sheet::begin(WIDTH, height, caption, &chart.legend());
    let ordinates: Vec<Scale> = panels.iter().map(|panel| chart.ordinate(panel)).collect();
    let left = ordinates.iter().map(Scale::room).fold(0.0, f64::max);
    let parts = body.rows(panels.len()).into_iter().zip(ordinates);
    for (index, ((part, ordinate), panel)) in parts.zip(&panels).enumerate() {
        let abscissa = chart.abscissa(index + 1 == panels.len());
        chart.draw_panel(&mut canvas, part, panel, (left, abscissa, ordinate));
    }
    Ok(canvas.into_svg())
}

/// A landing with its table, and a name if there are several.
struct Landing<'t> {
    table: &'t HistoryTable,
    history: &'t History,
    name: Option<String>,
}

fn landings(tables: &[(String, HistoryTable)]) -> Vec<Landing<'_>> {
    let are_many = tables.len() > 1;
    let all = tables.iter().flat_map(|(name, table)| {
        table.landings.iter().map(move |history| {
            let condition = condition(table, history);
            let name = match (are_many, condition) {
                (false, condition) => condition,
                (true, None) => Some(name.clone()),
                (true, Some(condition)) => Some(format!("{name}, {condition}")),
            };
            Landing {
                table,
                history,
                name,
            }
        })
    });
    all.collect()
}

/// The condition that distinguishes a landing of a table from the others.
fn condition(table: &HistoryTable, history: &History) -> Option<String> {
    let title = axis_title(table.condition.as_deref()?);
    let (name, unit) = title.split_once(", ").unwrap_or((&title, ""));
    let symbol = name.rsplit(' ').next().unwrap_or(name);
    let text = format!("{symbol} = {} {unit}", label(history.condition?));
    Some(text.trim_end().to_owned())
}

/// Landings drawn over the same time.
struct Chart<'t> {
    landings: Vec<Landing<'t>>,
    are_curves_coloured: bool,
    /// Time of the last instant, s.
    end: f64,
}

impl Chart<'_> {
    fn style(&self, landing: usize, curve: usize, width: f64) -> Style {
        let colour = if self.are_curves_coloured {
            curve
        } else {
            landing
        };
        Style::stroke(palette::curve(colour), width).dashed(palette::dashes(landing))
    }

    /// Distinguishes landings, and explains thick lines and circles.
    fn legend(&self) -> Vec<Entry> {
        let named = self.landings.iter().enumerate();
        let named = named.filter_map(|(index, landing)| Some((index, landing.name.clone()?)));
        let sample = |index: usize| {
            if self.are_curves_coloured {
                Style::stroke(palette::TEXT, CONTACT).dashed(palette::dashes(index))
            } else {
                self.style(index, 0, CONTACT)
            }
        };
        let mut entries: Vec<Entry> = named
            .map(|(index, name)| (Mark::Line(sample(index)), name))
            .collect();
        let mut instants = self
            .landings
            .iter()
            .flat_map(|landing| &landing.history.instants);
        if instants.clone().any(|instant| instant.is_free) {
            let thick = Style::stroke(palette::TEXT, FREE);
            entries.push((Mark::Line(thick), "free flight".to_owned()));
        }
        if instants.any(|instant| instant.printed.iter().any(Option::is_some)) {
            let words = "printed in 1966".to_owned();
            entries.push((Mark::Ring(palette::STATEMENT), words));
        }
        entries
    }

    fn abscissa(&self, is_last: bool) -> Scale {
        let title = if is_last {
            "Time after first contact, s"
        } else {
            ""
        };
        scale(title, (0.0, self.end.max(f64::MIN_POSITIVE)), 12)
    }

    /// The vertical axis of a panel, from the least of its values to the greatest.
    fn ordinate(&self, panel: &Panel) -> Scale {
        let values = panel.curves.iter().flat_map(|curve| {
            let drawn = self.landings.iter().flat_map(|landing| {
                let value = landing.value(curve);
                let instants = landing.history.instants.iter();
                instants.filter_map(move |instant| value.as_ref().map(|value| value(instant)))
            });
            let printed = self
                .landings
                .iter()
                .flat_map(|landing| landing.printed(curve));
            drawn.chain(printed.map(|(_, value)| value))
        });
        let (low, high) = values.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| {
            (low.min(value), high.max(value))
        });
        let (low, high) = if low > high { (0.0, 0.0) } else { (low, high) };
        // Constants get an axis about them.
        let margin = (0.06 * (high - low)).max(1e-6 * low.abs()).max(1e-9);
        scale(&panel.title, (low - margin, high + margin), 6)
    }

    fn draw_panel(
        &self,
        canvas: &mut Canvas,
        part: Area,
        panel: &Panel,
        (left, abscissa, ordinate): (f64, Scale, Scale),
    ) {
        let names: Vec<Entry> = match panel.curves.as_slice() {
            [_] => Vec::new(),
            curves => {
                let curves = curves.iter().enumerate();
                let line = |index| Mark::Line(Style::stroke(palette::curve(index), CONTACT));
                let entries = curves.map(|(index, curve)| (line(index), curve.name.clone()));
                entries.collect()
            }
        };
        let rows = legend::rows(&names, part.width() - left);
        let room = LEGEND * rows.len() as f64;
        let part = Area {
            top: part.top + room,
            ..part
        };
        let frame = Frame::with_left(part, left, abscissa, ordinate);
        let middle = 0.5 * (frame.area.left + frame.area.right);
        legend::draw(canvas, &rows, middle, part.top - room + 0.7 * LEGEND);
        frame.draw(canvas, Style::stroke(palette::GRID, 1.0));
        for (index, landing) in self.landings.iter().enumerate() {
            for (number, curve) in panel.curves.iter().enumerate() {
                for (points, is_free) in landing.stretches(curve) {
                    let width = if is_free { FREE } else { CONTACT };
                    canvas.curve(&frame.places(points), self.style(index, number, width));
                }
                for point in landing.printed(curve) {
                    let style = Style::stroke(palette::STATEMENT, 1.5);
                    canvas.circle(frame.place(point), palette::MARK - 1.0, style);
                }
            }
        }
    }
}

fn scale(title: &str, (from, to): (f64, f64), count: usize) -> Scale {
    Scale::new(title, (from, to), round_values(from, to, count))
}

impl Landing<'_> {
    /// Indices of a curve's columns in the table, if it has them all.
    fn columns(&self, curve: &Curve) -> Option<Vec<usize>> {
        let quantities = &self.table.quantities;
        let column = |name: &String| quantities.iter().position(|known| known == name);
        curve.columns.iter().map(column).collect()
    }

    /// The value of a curve at an instant, if the table has its columns.
    fn value(&self, curve: &Curve) -> Option<impl Fn(&Instant) -> f64 + use<>> {
        let columns = self.columns(curve)?;
        Some(move |instant: &Instant| columns.iter().map(|column| instant.values[*column]).sum())
    }

    /// Times and printed values of a curve.
    fn printed(&self, curve: &Curve) -> Vec<Point> {
        // No sums were printed.
        let columns = self.columns(curve).unwrap_or_default();
        let [column] = columns[..] else {
            return Vec::new();
        };
        let instants = self.history.instants.iter();
        instants
            .filter_map(|instant| Some((instant.time, instant.printed[column]?)))
            .collect()
    }

    /// Stretches of contact and of free flight of a curve. Each begins at the end of the last one.
    fn stretches(&self, curve: &Curve) -> Vec<(Vec<Point>, bool)> {
        let Some(value) = self.value(curve) else {
            return Vec::new();
        };
        let mut stretches: Vec<(Vec<Point>, bool)> = Vec::new();
        for run in self
            .history
            .instants
            .chunk_by(|a, b| a.is_free == b.is_free)
        {
            let last = stretches.last().and_then(|(points, _)| points.last());
            let points = run.iter().map(|instant| (instant.time, value(instant)));
            let points = last.copied().into_iter().chain(points).collect();
            stretches.push((points, run[0].is_free));
        }
        stretches
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn drawn(tables: &[(&str, &str)], columns: &[&str]) -> String {
        let tables = tables.iter().map(|(name, text)| {
            let table = HistoryTable::parse(text).unwrap();
            ((*name).to_owned(), table)
        });
        let columns: Vec<String> = columns.iter().map(|name| (*name).to_owned()).collect();
        draw(&tables.collect::<Vec<_>>(), &columns, &Caption::default()).unwrap()
    }

    #[test]
    fn every_quantity_has_a_panel_and_free_flight_is_thick() {
        let text = "tip_azimuth_deg,t_s,pitch_deg,angular_velocity_x_dps,touches\n\
                    90,0,1,-3,1\n90,0.5,2,-2,0\n90,1,2,-2,0\n-90,0,3,1,1\n-90,1,3,2,1\n";
        let svg = drawn(&[("", text)], &[]);
        assert!(svg.contains("Pitch angle") && svg.contains("Angular velocity about x"));
        assert!(svg.contains("Γ = 90 deg") && svg.contains("Γ = \u{2212}90 deg"));
        // One stretch in each panel, and the legend's.
        assert_eq!(svg.matches("stroke-width=\"4\"").count(), 3);
        assert!(svg.contains("free flight"));
    }

    #[test]
    fn printed_values_are_circles() {
        let text = "t_s,y_rate_fps,y_rate_1966_fps\n0,1,1.1\n0.5,2,\n1,3,3\n";
        let svg = drawn(&[("", text)], &[]);
        // Two values, and the legend's.
        assert_eq!(svg.matches("<circle").count(), 3);
        assert!(svg.contains("printed in 1966"));
    }

    #[test]
    fn several_tables_lie_over_each_other_each_with_its_dashes() {
        let one = "t_s,pitch_deg,roll_deg\n0,1,2\n1,2,3\n";
        let other = "t_s,pitch_deg\n0,1\n2,4\n";
        let svg = drawn(
            &[("one", one), ("other", other)],
            &["pitch_deg", "roll_deg"],
        );
        assert!(svg.contains(">one</text>") && svg.contains(">other</text>"));
        assert!(svg.contains("Angle, deg") && svg.contains(">pitch angle Ψ</text>"));
        // Pitch of the other landing, and the legend's sample.
        assert_eq!(svg.matches("stroke-dasharray").count(), 2);
        // Time goes on to the end of the longer.
        assert!(svg.contains(">2</text>"));
    }
}
