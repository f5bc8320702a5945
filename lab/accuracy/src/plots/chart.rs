//! A chart of points in groups. A line joins all points of a group, or those that no other beats.

use plotters::coord::Shift;
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};
use plotters::style::{FontStyle, register_font};

use super::labels::{Area, apart, beside};
use super::scale::{Kind, Scale, written};
use crate::pareto;

/// Width and height in pixels.
pub(super) const SIZE: (u32, u32) = (960, 600);
/// The margins around the frame.
const MARGIN: Area = Area { left: 70.0, top: 84.0, right: 24.0, bottom: 62.0 };
/// The width for names at the ends of lines, in pixels.
const ENDS: f64 = 130.0;
const FONT: &str = "sans-serif";
const TEXT: u32 = 14;
const TITLE: u32 = 19;
const GREY: RGBColor = RGBColor(110, 110, 110);
const PALE: RGBColor = RGBColor(228, 228, 228);
const FRONT: RGBColor = RGBColor(60, 60, 60);

/// Colours that colour-blind readers can distinguish (Okabe and Ito), and darker versions of them.
const COLOURS: [RGBColor; 12] = [
    RGBColor(213, 94, 0),
    RGBColor(0, 114, 178),
    RGBColor(230, 159, 0),
    RGBColor(86, 180, 233),
    RGBColor(0, 158, 115),
    RGBColor(204, 121, 167),
    RGBColor(120, 94, 40),
    RGBColor(0, 0, 0),
    RGBColor(140, 40, 40),
    RGBColor(90, 60, 160),
    RGBColor(100, 130, 20),
    RGBColor(40, 90, 90),
];

#[derive(Clone, Debug)]
pub(super) struct Axis {
    pub label: String,
    pub kind: Kind,
    /// Whether larger values are better.
    pub rising: bool,
}

/// A point and its name.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Point {
    pub name: String,
    pub x: f64,
    pub y: f64,
    pub colour: usize,
}

/// How the points of a group are drawn.
#[derive(Clone, Debug)]
pub(super) enum Group {
    /// Rivals: each point has a name, and a line joins those that no other beats.
    Rivals(Vec<Point>),
    /// A course: a line joins all points, and the last one has the name.
    Course(Vec<Point>),
}

#[derive(Clone, Debug)]
pub(super) struct Chart {
    pub title: String,
    pub note: String,
    pub x: Axis,
    pub y: Axis,
    pub groups: Vec<Group>,
}

impl Group {
    pub fn points(&self) -> &[Point] {
        match self {
            Self::Rivals(points) | Self::Course(points) => points,
        }
    }

    pub fn rivals(&self) -> Option<&[Point]> {
        matches!(self, Self::Rivals(_)).then(|| self.points())
    }

    fn course(&self) -> Option<&[Point]> {
        matches!(self, Self::Course(_)).then(|| self.points())
    }
}

/// Registers the font with which the plotting crate draws and measures text.
pub(super) fn use_font() -> Result<(), String> {
    for (style, bytes) in
        [(FontStyle::Normal, dejavu::sans::regular()), (FontStyle::Bold, dejavu::sans::bold())]
    {
        register_font(FONT, style, bytes).map_err(|_| "the font is not read".to_owned())?;
    }
    Ok(())
}

/// A chart's state while it is drawn.
struct Sheet<'a, DB: DrawingBackend> {
    area: &'a DrawingArea<DB, Shift>,
    /// The factor by which all lengths are multiplied.
    zoom: u32,
    frame: Area,
    x: Scale,
    y: Scale,
}

type Drawn<DB> = Result<(), DrawingAreaErrorKind<<DB as DrawingBackend>::ErrorType>>;

impl Chart {
    /// Draws the chart on an area that is `zoom` times as large as [`SIZE`].
    pub fn draw<DB: DrawingBackend>(&self, area: &DrawingArea<DB, Shift>, zoom: u32) -> Drawn<DB> {
        area.fill(&WHITE)?;
        let points = || self.groups.iter().flat_map(Group::points);
        let ends = self.groups.iter().any(|group| group.course().is_some());
        let [width, height] = [SIZE.0, SIZE.1].map(f64::from);
        let sheet = Sheet {
            area,
            zoom,
            frame: Area {
                right: width - MARGIN.right - if ends { ENDS } else { 0.0 },
                bottom: height - MARGIN.bottom,
                ..MARGIN
            },
            x: Scale::new(self.x.kind, points().map(|point| point.x)),
            y: Scale::new(self.y.kind, points().map(|point| point.y)),
        };
        sheet.axes(self)?;
        for group in &self.groups {
            match group {
                Group::Rivals(points) => sheet.front(&self.x, points)?,
                Group::Course(points) => sheet.course(points)?,
            }
        }
        sheet.names(&self.x, &self.groups)?;
        sheet.ends(&self.groups)?;
        area.present()
    }
}

impl<DB: DrawingBackend> Sheet<'_, DB> {
    fn at(&self, x: f64, y: f64) -> (f64, f64) {
        let Area { left, top, right, bottom } = self.frame;
        (left + self.x.place(x) * (right - left), bottom - self.y.place(y) * (bottom - top))
    }

    fn places(&self, points: &[&Point]) -> Vec<(f64, f64)> {
        points.iter().map(|point| self.at(point.x, point.y)).collect()
    }

    fn pixel(&self, (x, y): (f64, f64)) -> (i32, i32) {
        let zoom = f64::from(self.zoom);
        ((x * zoom).round() as i32, (y * zoom).round() as i32)
    }

    fn text(
        &self,
        text: &str,
        at: (f64, f64),
        size: u32,
        colour: &RGBColor,
        pos: Pos,
    ) -> Drawn<DB> {
        let style = TextStyle::from((FONT, size * self.zoom).into_font()).color(colour).pos(pos);
        self.area.draw_text(text, &style, self.pixel(at))
    }

    fn line(&self, path: Vec<(f64, f64)>, style: impl Into<ShapeStyle>) -> Drawn<DB> {
        let style = style.into();
        let style = style.stroke_width(style.stroke_width * self.zoom);
        let path: Vec<(i32, i32)> = path.into_iter().map(|at| self.pixel(at)).collect();
        self.area.draw(&PathElement::new(path, style))
    }

    fn circle(&self, at: (f64, f64), radius: u32, style: ShapeStyle) -> Drawn<DB> {
        self.area.draw(&Circle::new(self.pixel(at), radius * self.zoom, style))
    }

    fn axes(&self, chart: &Chart) -> Drawn<DB> {
        let Area { left, top, right, bottom } = self.frame;
        for tick in self.x.ticks() {
            let x = left + self.x.place(tick) * (right - left);
            self.line(vec![(x, top), (x, bottom)], PALE)?;
            let below = Pos::new(HPos::Center, VPos::Top);
            self.text(&written(tick), (x, bottom + 7.0), TEXT, &GREY, below)?;
        }
        for tick in self.y.ticks() {
            let y = bottom - self.y.place(tick) * (bottom - top);
            self.line(vec![(left, y), (right, y)], PALE)?;
            let beside = Pos::new(HPos::Right, VPos::Center);
            self.text(&written(tick), (left - 8.0, y), TEXT, &GREY, beside)?;
        }
        let corners = vec![(left, top), (left, bottom), (right, bottom)];
        self.line(corners, GREY)?;
        let from_left = Pos::new(HPos::Left, VPos::Top);
        self.text(&chart.title, (14.0, 10.0), TITLE, &BLACK, from_left)?;
        self.text(&chart.note, (14.0, 36.0), TEXT - 1, &GREY, from_left)?;
        self.text(&chart.y.label, (14.0, 60.0), TEXT, &BLACK, from_left)?;
        let under = Pos::new(HPos::Right, VPos::Top);
        self.text(&chart.x.label, (right, bottom + 34.0), TEXT, &BLACK, under)
    }

    /// The path from each point that no other beats to the next.
    fn front_path(&self, x: &Axis, points: &[Point]) -> Vec<(f64, f64)> {
        let front = not_beaten(x, points).into_iter();
        front.map(|at| self.at(points[at].x, points[at].y)).collect()
    }

    /// Draws all points, with a ring around those that no other beats, and the line that joins
    /// these.
    fn front(&self, x: &Axis, points: &[Point]) -> Drawn<DB> {
        let front = not_beaten(x, points);
        self.line(self.front_path(x, points), FRONT.stroke_width(2))?;
        for (number, point) in points.iter().enumerate() {
            let at = self.at(point.x, point.y);
            let colour = colour(point);
            self.circle(at, 5, colour.filled())?;
            if front.contains(&number) {
                self.circle(at, 8, FRONT.stroke_width(2 * self.zoom))?;
            }
        }
        Ok(())
    }

    fn course(&self, points: &[Point]) -> Drawn<DB> {
        let Some(last) = points.last() else {
            return Ok(());
        };
        let path = points.iter().map(|point| self.at(point.x, point.y));
        self.line(path.clone().collect(), colour(last).stroke_width(2))?;
        for at in path {
            self.circle(at, 3, colour(last).filled())?;
        }
        Ok(())
    }

    /// Draws the names of rivals next to their points.
    fn names(&self, x: &Axis, groups: &[Group]) -> Drawn<DB> {
        let fronts = || groups.iter().filter_map(Group::rivals);
        let rivals: Vec<&Point> = fronts().flatten().collect();
        let places = self.places(&rivals);
        let style = TextStyle::from((FONT, TEXT).into_font());
        let sizes = rivals.iter().map(|point| {
            let size = self.area.estimate_text_size(&point.name, &style);
            size.map(|(width, height)| (f64::from(width) + 6.0, f64::from(height) + 2.0))
        });
        let sizes = sizes.collect::<Result<Vec<_>, _>>()?;
        let lines: Vec<_> = fronts().map(|points| self.front_path(x, points)).collect();
        let areas = beside(&places, &sizes, &lines, &self.frame);
        for ((point, place), area) in rivals.iter().zip(places).zip(areas) {
            let middle =
                (f64::midpoint(area.left, area.right), f64::midpoint(area.top, area.bottom));
            let nearest = area.nearest(place);
            let far = (nearest.0 - place.0).abs().max((nearest.1 - place.1).abs());
            if far > 12.0 {
                self.line(vec![place, nearest], colour(point).mix(0.5))?;
            }
            let centred = Pos::new(HPos::Center, VPos::Center);
            self.text(&point.name, middle, TEXT, &colour(point), centred)?;
        }
        Ok(())
    }

    /// Draws the names of courses at their ends.
    fn ends(&self, groups: &[Group]) -> Drawn<DB> {
        let courses = groups.iter().filter_map(|group| group.course()?.last());
        let courses: Vec<&Point> = courses.collect();
        let places = self.places(&courses);
        let heights: Vec<f64> = places.iter().map(|(_, y)| *y).collect();
        let moved = apart(&heights, 18.0, self.frame.top, self.frame.bottom);
        for ((point, place), height) in courses.iter().zip(places).zip(moved) {
            let from = self.frame.right + 26.0;
            let path = vec![place, (self.frame.right + 4.0, place.1), (from, height)];
            self.line(path, colour(point).mix(0.5))?;
            let beside = Pos::new(HPos::Left, VPos::Center);
            self.text(&point.name, (from + 4.0, height), TEXT, &colour(point), beside)?;
        }
        Ok(())
    }
}

/// The indices of the points that no other beats, the cheapest first.
pub(super) fn not_beaten(x: &Axis, points: &[Point]) -> Vec<usize> {
    let sign = if x.rising { -1.0 } else { 1.0 };
    let points: Vec<(f64, f64)> = points.iter().map(|point| (sign * point.x, point.y)).collect();
    pareto::front(&points)
}

fn colour(point: &Point) -> RGBColor {
    COLOURS[point.colour % COLOURS.len()]
}
