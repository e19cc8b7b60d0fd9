//! Diagrams as SVG, readable in print and by the colour-blind: each curve has a colour, a mark and a name beside it.

use plotters::coord::Shift;
use plotters::prelude::{
    ChartBuilder, Circle, Cross, DrawingArea, IntoDrawingArea, IntoFont, LineSeries, PathElement,
    RGBColor, Rectangle, SVGBackend, Text, TriangleMarker, WHITE,
};
use plotters::style::{Color, ShapeStyle};
use std::ops::Range;

/// A surface that is drawn on.
pub(super) type Area<'a> = DrawingArea<SVGBackend<'a>, Shift>;

/// Colours that stay apart for every kind of colour vision (Okabe and Ito 2008), black first.
const PALETTE: [RGBColor; 8] = [
    RGBColor(0, 0, 0),
    RGBColor(213, 94, 0),
    RGBColor(0, 114, 178),
    RGBColor(0, 158, 115),
    RGBColor(204, 121, 167),
    RGBColor(230, 159, 0),
    RGBColor(86, 180, 233),
    RGBColor(120, 120, 120),
];

/// Marks are drawn on curves of at most so many points, and about so many of them.
const MARKED: usize = 60;
const MARKS: usize = 12;
const FONT: &str = "sans-serif";

/// A curve.
pub(super) struct Curve {
    pub(super) name: String,
    pub(super) points: Vec<(f64, f64)>,
}

/// An axis: what it shows, from where to where, and how its numbers are written.
pub(super) struct Scale<'a> {
    pub(super) name: &'a str,
    pub(super) range: Range<f64>,
    pub(super) label: &'a dyn Fn(&f64) -> String,
}

/// Draws on a new picture of the size.
pub(super) fn picture(
    size: (u32, u32),
    draw: impl FnOnce(&Area<'_>) -> Result<(), String>,
) -> Result<String, String> {
    let mut svg = String::new();
    {
        let area = SVGBackend::with_string(&mut svg, size).into_drawing_area();
        area.fill(&WHITE).map_err(said)?;
        draw(&area)?;
        area.present().map_err(said)?;
    }
    Ok(svg)
}

/// An error of the drawing library as its text.
pub(super) fn said(error: impl std::fmt::Display) -> String {
    error.to_string()
}

/// The colour of the curve of this number.
pub(super) fn colour(number: usize) -> RGBColor {
    PALETTE[number % PALETTE.len()]
}

/// Curves with their axes; names stand to the right.
pub(super) fn curves(
    area: &Area<'_>,
    title: &str,
    x: &Scale<'_>,
    y: &Scale<'_>,
    curves: &[Curve],
) -> Result<(), String> {
    let (width, _) = area.dim_in_pixel();
    let (plot, legend) = area.split_horizontally(width.saturating_sub(190));
    let mut chart = ChartBuilder::on(&plot)
        .margin(10)
        .caption(title, (FONT, 17))
        .x_label_area_size(42)
        .y_label_area_size(68)
        .build_cartesian_2d(x.range.clone(), y.range.clone())
        .map_err(said)?;
    chart
        .configure_mesh()
        .x_desc(x.name)
        .y_desc(y.name)
        .x_label_formatter(x.label)
        .y_label_formatter(y.label)
        .x_labels(9)
        .y_labels(9)
        .label_style((FONT, 13))
        .axis_desc_style((FONT, 14))
        .bold_line_style(RGBColor(215, 215, 215))
        .light_line_style(WHITE)
        .draw()
        .map_err(said)?;
    for (number, curve) in curves.iter().enumerate() {
        let points = || curve.points.iter().copied();
        chart
            .draw_series(LineSeries::new(points(), colour(number).stroke_width(2)))
            .map_err(said)?;
        if curve.points.len() <= MARKED {
            let apart = curve.points.len().div_ceil(MARKS);
            for at in points().step_by(apart.max(1)) {
                Mark { at, number }.on_chart(&mut chart)?;
            }
        }
    }
    names(&legend, curves)
}

/// A line below a picture, and what is left above it.
pub(super) fn above_note<'a>(area: &Area<'a>, note: &str) -> Result<Area<'a>, String> {
    let (_, height) = area.dim_in_pixel();
    let (rest, foot) = area.split_vertically(height.saturating_sub(22));
    let style = (FONT, 12).into_font();
    let text = Text::new(note.to_owned(), (12, 4), style);
    foot.draw(&text).map_err(said)?;
    Ok(rest)
}

/// The names of curves beside their marks.
fn names(legend: &Area<'_>, curves: &[Curve]) -> Result<(), String> {
    for (number, curve) in curves.iter().enumerate() {
        let y = 44 + 22 * i32::try_from(number).unwrap_or(0);
        let line = PathElement::new(vec![(4, y), (32, y)], colour(number).stroke_width(2));
        legend.draw(&line).map_err(said)?;
        if curve.points.len() <= MARKED {
            Mark {
                at: (18, y),
                number,
            }
            .on_area(legend)?;
        }
        let style = (FONT, 13).into_font();
        let text = Text::new(curve.name.clone(), (40, y - 6), style);
        legend.draw(&text).map_err(said)?;
    }
    Ok(())
}

/// The mark of the curve of this number.
struct Mark<C> {
    at: (C, C),
    number: usize,
}

impl Mark<f64> {
    fn on_chart<'a, 'b>(
        self,
        chart: &mut plotters::chart::ChartContext<
            'a,
            SVGBackend<'b>,
            plotters::coord::cartesian::Cartesian2d<
                plotters::coord::types::RangedCoordf64,
                plotters::coord::types::RangedCoordf64,
            >,
        >,
    ) -> Result<(), String> {
        let (at, style) = (self.at, self.style());
        let drawn = match self.shape() {
            0 => chart.draw_series([Circle::new(at, 4, style)]).map(|_| ()),
            1 => chart
                .draw_series([TriangleMarker::new(at, 5, style)])
                .map(|_| ()),
            2 => chart.draw_series([Cross::new(at, 4, style)]).map(|_| ()),
            _ => chart
                .draw_series([Circle::new(at, 4, self.hollow())])
                .map(|_| ()),
        };
        drawn.map_err(said)
    }
}

impl<C> Mark<C> {
    /// One of four, another for the next round of colours.
    fn shape(&self) -> usize {
        (self.number + self.number / PALETTE.len()) % 4
    }

    fn style(&self) -> ShapeStyle {
        colour(self.number).filled().stroke_width(2)
    }

    fn hollow(&self) -> ShapeStyle {
        colour(self.number).stroke_width(2)
    }
}

impl Mark<i32> {
    fn on_area(self, area: &Area<'_>) -> Result<(), String> {
        let (at, style) = (self.at, self.style());
        let drawn = match self.shape() {
            0 => area.draw(&Circle::new(at, 4, style)),
            1 => area.draw(&TriangleMarker::new(at, 5, style)),
            2 => area.draw(&Cross::new(at, 4, style)),
            _ => area.draw(&Circle::new(at, 4, self.hollow())),
        };
        drawn.map_err(said)
    }
}

/// How bad, from 0 to 1, and the text; nothing where there is nothing to say.
pub(super) type Field = Option<(f64, String)>;

/// A table of numbers as fields of colour, from pale (good) to dark (bad), each with its text.
pub(super) fn heat(
    area: &Area<'_>,
    title: &str,
    columns: &[String],
    rows: &[(String, Vec<Field>)],
) -> Result<(), String> {
    let font = |size: i32| (FONT, size).into_font();
    let write = |text: &str, at: (i32, i32), size: i32| {
        area.draw(&Text::new(text.to_owned(), at, font(size)))
            .map_err(said)
    };
    write(title, (12, 10), 16)?;
    let (left, top, wide, high) = (190, 58, 78, 26);
    for (number, column) in columns.iter().enumerate() {
        let x = left + wide * i32::try_from(number).unwrap_or(0);
        write(column, (x + 6, top - 20), 13)?;
    }
    for (number, (name, fields)) in rows.iter().enumerate() {
        let y = top + high * i32::try_from(number).unwrap_or(0);
        write(name, (12, y + 6), 13)?;
        for (number, field) in fields.iter().enumerate() {
            let Some((part, text)) = field else { continue };
            let x = left + wide * i32::try_from(number).unwrap_or(0);
            let box_ = [(x, y), (x + wide - 2, y + high - 2)];
            area.draw(&Rectangle::new(box_, shade(*part).filled()))
                .map_err(said)?;
            let ink = if *part > 0.55 {
                WHITE
            } else {
                RGBColor(0, 0, 0)
            };
            let style = font(13).color(&ink);
            area.draw(&Text::new(text.clone(), (x + 8, y + 5), style))
                .map_err(said)?;
        }
    }
    Ok(())
}

/// From nearly white over orange to dark brown: one hue, so that its lightness alone says how bad.
fn shade(part: f64) -> RGBColor {
    let part = part.clamp(0.0, 1.0);
    let mix = |from: f64, to: f64| (from + (to - from) * part) as u8;
    RGBColor(mix(255.0, 90.0), mix(247.0, 25.0), mix(235.0, 5.0))
}

/// 10ⁿ as people write it; nothing between the powers.
pub(super) fn power_of_ten(exponent: f64) -> String {
    if (exponent - exponent.round()).abs() > 0.01 {
        return String::new();
    }
    // Without the sign of −0.
    let exponent = exponent.round() + 0.0;
    let digits = format!("{exponent:.0}");
    let raised = digits.chars().map(|digit| match digit {
        '-' => '⁻',
        '1' => '¹',
        '2' => '²',
        '3' => '³',
        '0' | '4'..='9' => {
            let value = digit.to_digit(10).unwrap_or(0);
            char::from_u32(0x2070 + value).unwrap_or(digit)
        }
        other => other,
    });
    format!("10{}", raised.collect::<String>())
}
