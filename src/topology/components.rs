//! The connected components of a curve in the plane, and which of them are inside which.
//!
//! Two kinds of pieces are joined: arcs over intervals with the points at their ends, which gives the components; and the cells
//! between arcs, across the gaps of the fibres, which gives the regions of the plane. A component is inside another one, B, if no way
//! from infinity that may cross everything but B reaches it. An unbounded component may have bounded loops, too.

use super::sweep::Sweep;

/// The kind of a component.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum ComponentKind {
    /// A bounded component that is not a point: without singular points it is a closed curve without crossings.
    Oval,
    /// A component that leaves every bounded region.
    Unbounded,
    /// An isolated point.
    Point,
}

impl ComponentKind {
    /// The name in documents.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Oval => "oval",
            Self::Unbounded => "unbounded",
            Self::Point => "point",
        }
    }
}

/// The arcs and points of one component.
#[derive(Clone, Debug)]
pub(super) struct Pieces {
    pub(super) kind: ComponentKind,
    /// Arcs as (interval, rank).
    pub(super) arcs: Vec<(usize, usize)>,
    /// Points as (fibre, index).
    pub(super) points: Vec<(usize, usize)>,
}

/// A partition of 0, …, n − 1 into sets.
struct Partition(Vec<usize>);

impl Partition {
    fn new(n: usize) -> Self {
        Self((0..n).collect())
    }

    fn find(&mut self, mut i: usize) -> usize {
        while self.0[i] != i {
            self.0[i] = self.0[self.0[i]];
            i = self.0[i];
        }
        i
    }

    fn join(&mut self, i: usize, j: usize) {
        let (i, j) = (self.find(i), self.find(j));
        self.0[i.max(j)] = i.min(j);
    }
}

/// The components of a curve.
#[derive(Clone, Debug)]
pub(super) struct Components {
    pub(super) list: Vec<Pieces>,
    /// The component of each arc.
    of_arc: Vec<Vec<usize>>,
    /// For each component, those directly inside.
    pub(super) contains: Vec<Vec<usize>>,
}

impl Components {
    pub(super) fn new(sweep: &Sweep) -> Self {
        let (list, of_arc) = connect(sweep);
        let mut components = Self {
            contains: vec![Vec::new(); list.len()],
            list,
            of_arc,
        };
        let inside = components.insides(&Regions::new(sweep, &components));
        for (inner, outer) in inside.iter().enumerate() {
            // The innermost one around a component is inside all the others around it.
            let direct = outer
                .iter()
                .find(|&&b| outer.iter().all(|c| *c == b || inside[b].contains(c)));
            if let Some(&direct) = direct {
                components.contains[direct].push(inner);
            }
        }
        components
    }

    /// The component of an arc.
    pub(super) fn of_arc(&self, interval: usize, rank: usize) -> usize {
        self.of_arc[interval][rank]
    }

    /// For each component, the ones around it.
    fn insides(&self, regions: &Regions) -> Vec<Vec<usize>> {
        let mut inside = vec![Vec::new(); self.list.len()];
        for (outer, pieces) in self.list.iter().enumerate() {
            if pieces.kind == ComponentKind::Point {
                continue;
            }
            let outside = regions.outside(outer);
            for (inner, region) in regions.beside.iter().enumerate() {
                if inner != outer && !outside[*region] {
                    inside[inner].push(outer);
                }
            }
        }
        inside
    }
}

type OfArc = Vec<Vec<usize>>;

/// The components, and the component of each arc.
fn connect(sweep: &Sweep) -> (Vec<Pieces>, OfArc) {
    let mut first_arc = vec![0];
    for arcs in &sweep.arcs {
        first_arc.push(first_arc[first_arc.len() - 1] + arcs.len());
    }
    let arcs = first_arc[first_arc.len() - 1];
    let mut first_point = vec![arcs];
    for fibre in &sweep.fibres {
        first_point.push(first_point[first_point.len() - 1] + fibre.points.len());
    }
    let total = first_point[first_point.len() - 1];
    let mut partition = Partition::new(total);
    for (index, fibre) in sweep.fibres.iter().enumerate() {
        for side in 0..2 {
            let mut rank = 0;
            for (place, point) in fibre.points.iter().enumerate() {
                for _ in 0..point.arcs[side] {
                    partition.join(first_arc[index + side] + rank, first_point[index] + place);
                    rank += 1;
                }
            }
        }
    }
    let mut list: Vec<Pieces> = Vec::new();
    let mut names: Vec<Option<usize>> = vec![None; total];
    let mut name = |item: usize, list: &mut Vec<Pieces>| {
        let root = partition.find(item);
        *names[root].get_or_insert_with(|| {
            list.push(Pieces {
                kind: ComponentKind::Oval,
                arcs: Vec::new(),
                points: Vec::new(),
            });
            list.len() - 1
        })
    };
    let last = sweep.arcs.len() - 1;
    let mut of_arc: OfArc = vec![Vec::new(); sweep.arcs.len()];
    // From left to right, so that the components are numbered in the order of their leftmost pieces.
    for interval in 0..=last {
        for rank in 0..sweep.arcs[interval].len() {
            let component = name(first_arc[interval] + rank, &mut list);
            list[component].arcs.push((interval, rank));
            if interval == 0 || interval == last {
                list[component].kind = ComponentKind::Unbounded;
            }
            of_arc[interval].push(component);
        }
        let Some(fibre) = sweep.fibres.get(interval) else {
            continue;
        };
        for place in 0..fibre.points.len() {
            let component = name(first_point[interval] + place, &mut list);
            list[component].points.push((interval, place));
        }
    }
    for pieces in &mut list {
        if pieces.arcs.is_empty() {
            pieces.kind = ComponentKind::Point;
        }
    }
    (list, of_arc)
}

/// The regions into which the curve cuts the plane.
struct Regions {
    count: usize,
    /// Pairs of regions on both sides of an arc of a component.
    across: Vec<(usize, usize, usize)>,
    /// The regions that reach infinity.
    unbounded: Vec<usize>,
    /// For each component, a region beside it.
    beside: Vec<usize>,
}

impl Regions {
    fn new(sweep: &Sweep, components: &Components) -> Self {
        // The cells over an interval with k arcs are 0, …, k from below.
        let mut first = vec![0];
        for arcs in &sweep.arcs {
            first.push(first[first.len() - 1] + arcs.len() + 1);
        }
        let count = first[first.len() - 1];
        let mut partition = Partition::new(count);
        for (index, fibre) in sweep.fibres.iter().enumerate() {
            for gap in 0..=fibre.points.len() {
                let [left, right] =
                    [0, 1].map(|side| first[index + side] + sweep.arcs_below(index, gap, side));
                partition.join(left, right);
            }
        }
        let mut across = Vec::new();
        let mut beside = vec![0; components.list.len()];
        for (interval, arcs) in sweep.arcs.iter().enumerate() {
            for rank in 0..arcs.len() {
                let component = components.of_arc(interval, rank);
                let below = partition.find(first[interval] + rank);
                let above = partition.find(first[interval] + rank + 1);
                across.push((below, above, component));
                beside[component] = below;
            }
        }
        for (component, pieces) in components.list.iter().enumerate() {
            if let (true, Some(&(fibre, place))) = (pieces.arcs.is_empty(), pieces.points.first()) {
                let cell = first[fibre] + sweep.arcs_below(fibre, place, 0);
                beside[component] = partition.find(cell);
            }
        }
        let last = sweep.arcs.len() - 1;
        let ends = first[0]..first[1];
        let mut unbounded: Vec<usize> = ends.chain(first[last]..count).collect();
        for (interval, arcs) in sweep.arcs.iter().enumerate() {
            unbounded.extend([first[interval], first[interval] + arcs.len()]);
        }
        let unbounded = unbounded.into_iter().map(|c| partition.find(c)).collect();
        Self {
            count,
            across,
            unbounded,
            beside,
        }
    }

    /// Which regions are reached from infinity without crossing a component.
    fn outside(&self, component: usize) -> Vec<bool> {
        let mut reached = vec![false; self.count];
        let mut open = self.unbounded.clone();
        for &region in &open {
            reached[region] = true;
        }
        let mut next: Vec<Vec<usize>> = vec![Vec::new(); self.count];
        for &(a, b, _) in self.across.iter().filter(|(_, _, c)| *c != component) {
            next[a].push(b);
            next[b].push(a);
        }
        while let Some(region) = open.pop() {
            for &other in &next[region] {
                if !reached[other] {
                    reached[other] = true;
                    open.push(other);
                }
            }
        }
        reached
    }
}
