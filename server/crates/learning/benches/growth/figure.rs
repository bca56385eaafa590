//! Curves with logarithmic axes, as SVG.

use std::fmt::Write;

const WIDTH: f64 = 640.0;
const HEIGHT: f64 = 400.0;
/// Where the axes run.
const LEFT: f64 = 70.0;
const RIGHT: f64 = WIDTH - 20.0;
const TOP: f64 = 20.0;
const BOTTOM: f64 = HEIGHT - 55.0;
/// Readable to people who do not tell red from green, and with marks of their own.
const COLOURS: [&str; 3] = ["#0072b2", "#d55e00", "#009e73"];
const AXIS: &str = "#444";
const GRID: &str = "#ddd";

/// Curves over one axis.
pub struct Figure {
    pub file: &'static str,
    /// What the axes show, with units.
    pub x: &'static str,
    pub y: &'static str,
    pub series: Vec<Series>,
}

/// One curve.
pub struct Series {
    pub name: String,
    pub points: Vec<(f64, f64)>,
}

impl Series {
    pub fn named(name: &str) -> Series {
        Series {
            name: name.into(),
            points: Vec::new(),
        }
    }
}

/// A logarithmic axis: values from `low` to `high` are drawn from `from` to `to`.
struct Axis {
    low: f64,
    high: f64,
    from: f64,
    to: f64,
}

impl Axis {
    /// With a little room beyond the values.
    fn around(values: impl Iterator<Item = f64>, from: f64, to: f64) -> Axis {
        let (low, high) = values.fold((f64::INFINITY, 0.0f64), |(low, high), value| {
            (low.min(value), high.max(value))
        });
        Axis {
            low: low / 1.2,
            high: high * 1.2,
            from,
            to,
        }
    }

    fn at(&self, value: f64) -> f64 {
        let share = (value / self.low).ln() / (self.high / self.low).ln();
        self.from + share * (self.to - self.from)
    }

    /// 1, 2 and 5 times powers of ten; powers of ten alone on a long axis.
    fn ticks(&self) -> Vec<f64> {
        let steps: &[f64] = if self.high / self.low > 1e3 {
            &[1.0]
        } else {
            &[1.0, 2.0, 5.0]
        };
        let first = self.low.log10().floor() as i32;
        (first..first + 12)
            .flat_map(|power| steps.iter().map(move |step| step * 10f64.powi(power)))
            .filter(|tick| (self.low..=self.high).contains(tick))
            .collect()
    }
}

impl Figure {
    pub fn to_svg(&self) -> String {
        let points = || self.series.iter().flat_map(|series| &series.points);
        let x = Axis::around(points().map(|point| point.0), LEFT, RIGHT);
        let y = Axis::around(points().map(|point| point.1), BOTTOM, TOP);
        let mut svg = String::new();
        let mut put = |element: String| writeln!(svg, "{element}").unwrap();
        put(format!(
            r#"<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {HEIGHT}" font-family="sans-serif" font-size="13">"#
        ));
        put(format!(
            r#"<rect width="{WIDTH}" height="{HEIGHT}" fill="white"/>"#
        ));
        for tick in x.ticks() {
            let at = x.at(tick);
            put(line((at, TOP), (at, BOTTOM), GRID, ""));
            put(text((at, BOTTOM + 18.0), "middle", &number(tick)));
        }
        for tick in y.ticks() {
            let at = y.at(tick);
            put(line((LEFT, at), (RIGHT, at), GRID, ""));
            put(text((LEFT - 8.0, at + 4.0), "end", &number(tick)));
        }
        put(line((LEFT, BOTTOM), (RIGHT, BOTTOM), AXIS, ""));
        put(line((LEFT, TOP), (LEFT, BOTTOM), AXIS, ""));
        put(text(
            (0.5 * (LEFT + RIGHT), HEIGHT - 12.0),
            "middle",
            self.x,
        ));
        let turned = format!(
            r#"<g transform="translate(18 {}) rotate(-90)">"#,
            0.5 * (TOP + BOTTOM)
        );
        put(format!(
            "{turned}{}</g>",
            text((0.0, 0.0), "middle", self.y)
        ));
        if let Some(&(first_x, first_y)) = points().next() {
            // As if cost grew in proportion, as far as the axes go.
            let share = (x.high / first_x).min(y.high / first_y);
            let end = (x.at(first_x * share), y.at(first_y * share));
            let dashed = r#" stroke-dasharray="5 4""#;
            put(line((x.at(first_x), y.at(first_y)), end, "#888", dashed));
        }
        for (series, (colour, mark)) in self.series.iter().zip(COLOURS.iter().zip(0..)) {
            let places: Vec<(f64, f64)> = series
                .points
                .iter()
                .map(|&(a, b)| (x.at(a), y.at(b)))
                .collect();
            let joined: Vec<String> = places
                .iter()
                .map(|(a, b)| format!("{a:.1},{b:.1}"))
                .collect();
            put(format!(
                r#"<polyline points="{}" fill="none" stroke="{colour}" stroke-width="2"/>"#,
                joined.join(" ")
            ));
            for &place in &places {
                put(marker(mark, place, colour));
            }
            let row = TOP + 18.0 + 20.0 * f64::from(mark);
            put(marker(mark, (LEFT + 20.0, row - 4.0), colour));
            put(text((LEFT + 32.0, row), "start", &series.name));
        }
        let row = TOP + 18.0 + 20.0 * self.series.len() as f64;
        let begin = (LEFT + 8.0, row - 4.0);
        put(line(
            begin,
            (LEFT + 28.0, row - 4.0),
            "#888",
            r#" stroke-dasharray="5 4""#,
        ));
        put(text((LEFT + 32.0, row), "start", "in proportion"));
        put("</svg>".into());
        svg
    }
}

/// Without more digits than it needs.
fn number(value: f64) -> String {
    let rounded = format!("{value:.4}");
    rounded
        .trim_end_matches('0')
        .trim_end_matches('.')
        .to_string()
}

fn line(from: (f64, f64), to: (f64, f64), colour: &str, more: &str) -> String {
    format!(
        r#"<line x1="{:.1}" y1="{:.1}" x2="{:.1}" y2="{:.1}" stroke="{colour}"{more}/>"#,
        from.0, from.1, to.0, to.1
    )
}

fn text(at: (f64, f64), anchor: &str, words: &str) -> String {
    format!(
        r#"<text x="{:.1}" y="{:.1}" text-anchor="{anchor}" fill="{AXIS}">{words}</text>"#,
        at.0, at.1
    )
}

/// A disc for the first curve, squares for the others.
fn marker(mark: i32, (x, y): (f64, f64), colour: &str) -> String {
    if mark == 0 {
        return format!(r#"<circle cx="{x:.1}" cy="{y:.1}" r="4" fill="{colour}"/>"#);
    }
    format!(
        r#"<rect x="{:.1}" y="{:.1}" width="8" height="8" fill="{colour}"/>"#,
        x - 4.0,
        y - 4.0
    )
}
