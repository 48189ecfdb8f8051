//! Kinds of cases in turn, on all processors, with counts and findings.

use std::any::Any;
use std::cell::{Cell, RefCell};
use std::env;
use std::fmt::Write as _;
use std::fs;
use std::io::{self, Write as _};
use std::ops::Range;
use std::panic::{self, AssertUnwindSafe};
use std::sync::atomic::{AtomicU64, Ordering::Relaxed};
use std::sync::{Mutex, RwLock};
use std::time::{Duration, Instant, SystemTime, UNIX_EPOCH};

use super::draw::Draw;

/// What a case costs: up to about a millisecond, or more.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Weight {
    Cheap,
    Heavy,
}

/// How a case ended that found nothing wrong.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Outcome {
    /// Everything that was claimed was compared.
    Checked,
    /// Nothing was claimed: a limit was reached, or the question was left undecided.
    Open,
}

/// A kind of cases. A case panics if something is wrong.
pub(crate) struct Kind {
    name: &'static str,
    weight: Weight,
    /// How many cases run by default.
    few: u64,
    run: fn(&mut Draw) -> Outcome,
}

impl Kind {
    pub(crate) fn new(
        name: &'static str,
        weight: Weight,
        few: u64,
        run: fn(&mut Draw) -> Outcome,
    ) -> Self {
        Self {
            name,
            weight,
            few,
            run,
        }
    }

    fn finding(&self, seed: u64, draw: Draw, differed: String) -> Finding {
        Finding {
            kind: self.name,
            seed,
            input: draw.input,
            differed,
        }
    }
}

/// A case that found something wrong.
#[derive(Debug)]
struct Finding {
    kind: &'static str,
    seed: u64,
    input: String,
    differed: String,
}

/// How many cases of one kind were run.
#[derive(Default)]
struct Count {
    checked: AtomicU64,
    open: AtomicU64,
    failed: AtomicU64,
    microseconds: AtomicU64,
}

/// The seed of the cases that run by default.
const FIXED_SEED: u64 = 20;
/// Every turn has seeds of its own, this many at most.
const SEEDS_OF_A_TURN: u64 = 1 << 20;
/// How long one kind goes on before it is the next one's turn.
const TURN: Duration = Duration::from_millis(300);
/// How often counts are printed.
const REPORT: Duration = Duration::from_secs(30);
/// More memory than this for one case is a finding.
pub(crate) const LARGEST_MEMORY: u64 = 1 << 30;
/// Only so many findings of a kind are printed in full.
const FINDINGS_SHOWN: usize = 5;

/// Turns read it; it is written where nothing may run beside a case.
static ALONE: RwLock<()> = RwLock::new(());

thread_local! {
    static IN_A_CASE: Cell<bool> = const { Cell::new(false) };
    static PLACE: RefCell<String> = const { RefCell::new(String::new()) };
}

/// Panics of cases are findings: they are not printed when they happen.
fn catch_panics_of_cases() {
    let before = panic::take_hook();
    panic::set_hook(Box::new(move |info| {
        if IN_A_CASE.get() {
            let place = info.location().map(ToString::to_string);
            PLACE.set(place.unwrap_or_default());
        } else {
            before(info);
        }
    }));
}

fn text_of(payload: &(dyn Any + Send)) -> String {
    let text = payload.downcast_ref::<&str>().map(ToString::to_string);
    let text = text.or_else(|| payload.downcast_ref::<String>().cloned());
    text.unwrap_or_else(|| "a panic without a message".into())
}

/// Runs the case with this seed: what it drew, and how it ended, with what differed in words.
fn attempt(kind: &Kind, seed: u64) -> (Draw, Result<Outcome, String>) {
    let mut draw = Draw::new(kind.name, seed);
    IN_A_CASE.set(true);
    let result = panic::catch_unwind(AssertUnwindSafe(|| (kind.run)(&mut draw)));
    IN_A_CASE.set(false);
    let result =
        result.map_err(|payload| format!("{} ({})", text_of(payload.as_ref()), PLACE.take()));
    (draw, result)
}

/// How the case with this seed ends.
fn run_case(kind: &Kind, seed: u64) -> Result<Outcome, Finding> {
    let (draw, result) = attempt(kind, seed);
    result.map_err(|differed| kind.finding(seed, draw, differed))
}

/// The largest memory that a process (`self`, or a number) has had so far, in bytes, where the system tells.
pub(crate) fn peak_memory_of(process: &str) -> Option<u64> {
    let status = fs::read_to_string(format!("/proc/{process}/status")).ok()?;
    let line = status.lines().find(|line| line.starts_with("VmHWM:"))?;
    let kilobytes: u64 = line.split_whitespace().nth(1)?.parse().ok()?;
    Some(kilobytes * 1024)
}

/// The largest memory that this process has had since the last call, in bytes; 0 where the system does not tell.
fn peak_memory() -> u64 {
    let peak = peak_memory_of("self");
    // The peak is set back to what is in use.
    let _ = fs::write("/proc/self/clear_refs", "5");
    peak.unwrap_or(0)
}

/// Repeats the cases of a turn one by one, and nothing beside them: those for which much memory is taken.
fn large_cases(kind: &Kind, seeds: Range<u64>) -> Vec<Finding> {
    let _alone = ALONE.write().unwrap();
    let mut large = Vec::new();
    for seed in seeds {
        // The first call ends the time before; between the two nothing happens, so that the second one tells what is in use.
        peak_memory();
        let before = peak_memory();
        let (draw, _) = attempt(kind, seed);
        let taken = peak_memory().saturating_sub(before);
        if taken > LARGEST_MEMORY {
            let differed = format!("{} MB of memory", taken >> 20);
            large.push(kind.finding(seed, draw, differed));
        }
    }
    large
}

fn say(text: &str) {
    // Standard error itself is not captured by the test harness; the campaign is watched while it runs.
    let _ = writeln!(io::stderr().lock(), "{text}");
}

fn shown(name: &str, finding: &Finding) -> String {
    let Finding {
        kind,
        seed,
        input,
        differed,
    } = finding;
    format!(
        "FOUND by {name}=0 {name}_KIND={kind} {name}_SEED={seed}\n  input: {input}\n  {differed}"
    )
}

fn table(kinds: &[&Kind], counts: &[Count]) -> String {
    let mut text = format!(
        "{:<18} {:<6} {:>10} {:>8} {:>7} {:>10}",
        "kind", "weight", "checked", "open", "failed", "us/case"
    );
    let mut sums = [[0; 3]; 2];
    for (kind, count) in kinds.iter().zip(counts) {
        let all = [&count.checked, &count.open, &count.failed].map(|n| n.load(Relaxed));
        let cases = all.iter().sum::<u64>().max(1);
        let [checked, open, failed] = all;
        let weight = format!("{:?}", kind.weight).to_lowercase();
        let each = count.microseconds.load(Relaxed) / cases;
        let _ = write!(
            text,
            "\n{:<18} {weight:<6} {checked:>10} {open:>8} {failed:>7} {each:>10}",
            kind.name
        );
        for (sum, n) in sums[usize::from(kind.weight == Weight::Heavy)]
            .iter_mut()
            .zip(all)
        {
            *sum += n;
        }
    }
    for (name, [checked, open, failed]) in ["cheap", "heavy"].iter().zip(sums) {
        let _ = write!(
            text,
            "\n{:<18} {name:<6} {checked:>10} {open:>8} {failed:>7}",
            "all"
        );
    }
    text
}

/// What the environment asks for, by variables that begin with `name`.
struct Plan {
    name: &'static str,
    /// How long fresh cases are drawn; `None` for the few cases by default.
    time: Option<Duration>,
    seed: u64,
}

impl Plan {
    fn of_environment(name: &'static str) -> Self {
        let number = || env::var(name).ok().map(|text| text.parse::<f64>().unwrap());
        let time = number().map(|minutes| Duration::from_secs_f64(minutes * 60.0));
        let now = || SystemTime::now().duration_since(UNIX_EPOCH).unwrap();
        let seed = env::var(format!("{name}_SEED")).ok();
        let seed = seed.map(|text| text.parse::<u64>().unwrap());
        let fresh = || now().as_nanos() as u64 & !(SEEDS_OF_A_TURN - 1);
        Self {
            name,
            seed: seed.unwrap_or_else(|| time.map_or(FIXED_SEED, |_| fresh())),
            time,
        }
    }
}

/// Runs kinds in turn, and panics at the end if a case found something wrong.
///
/// Variables of the environment that begin with `name` say for how long, from which seed, and which kinds; see the two programs
/// that use this.
pub(crate) fn campaign(name: &'static str, kinds: &[Kind]) {
    let asked = env::var(format!("{name}_KIND")).ok();
    let is_asked = |kind: &&Kind| {
        let names = asked.as_deref();
        names.is_none_or(|names| names.split(',').any(|name| name == kind.name))
    };
    let kinds: Vec<&Kind> = kinds.iter().filter(is_asked).collect();
    assert!(!kinds.is_empty(), "{asked:?} is no kind");
    catch_panics_of_cases();
    let plan = Plan::of_environment(name);
    let counts: Vec<Count> = kinds.iter().map(|_| Count::default()).collect();
    let findings = Mutex::new(Vec::new());
    let times_large = AtomicU64::new(0);
    let next_turn = AtomicU64::new(0);
    let threads = std::thread::available_parallelism().map_or(1, usize::from) as u64;
    if plan.time.is_some() {
        say(&format!("seed {}", plan.seed));
    }
    let start = Instant::now();
    let last_report = Mutex::new(start);
    let turns = kinds.len() as u64;
    let work = || {
        loop {
            let turn = next_turn.fetch_add(1, Relaxed);
            let is_over = match plan.time {
                None => turn >= turns,
                // One turn at least for every kind.
                Some(time) => turn >= turns && start.elapsed() >= time,
            };
            if is_over {
                return;
            }
            let index = (turn % turns) as usize;
            let alone = ALONE.read().unwrap();
            let large_before = times_large.load(Relaxed);
            let seeds = run_turn(kinds[index], &counts[index], &plan, turn, &findings);
            if peak_memory() > LARGEST_MEMORY {
                times_large.fetch_add(1, Relaxed);
            }
            drop(alone);
            // By a case of this turn, or by another one beside it.
            if times_large.load(Relaxed) > large_before {
                for finding in large_cases(kinds[index], seeds) {
                    counts[index].failed.fetch_add(1, Relaxed);
                    record(finding, name, &findings);
                }
            }
            let mut last = last_report.lock().unwrap();
            if plan.time.is_some() && last.elapsed() >= REPORT {
                *last = Instant::now();
                let next = plan
                    .seed
                    .wrapping_add(next_turn.load(Relaxed) * SEEDS_OF_A_TURN);
                let seconds = start.elapsed().as_secs();
                say(&format!(
                    "{}\nafter {seconds} s; the next seed is {next}",
                    table(&kinds, &counts)
                ));
            }
        }
    };
    std::thread::scope(|scope| {
        for _ in 0..threads {
            scope.spawn(work);
        }
    });
    let findings = findings.into_inner().unwrap();
    if plan.time.is_some() || !findings.is_empty() {
        say(&format!(
            "{}\nafter {} s from seed {}",
            table(&kinds, &counts),
            start.elapsed().as_secs(),
            plan.seed
        ));
    }
    let all: Vec<String> = findings.iter().map(|f| shown(name, f)).collect();
    assert!(all.is_empty(), "{} findings\n{}", all.len(), all.join("\n"));
}

/// Prints a finding, unless enough of its kind are known.
fn record(finding: Finding, name: &str, findings: &Mutex<Vec<Finding>>) {
    let mut all = findings.lock().unwrap();
    if all.iter().filter(|f| f.kind == finding.kind).count() < FINDINGS_SHOWN {
        say(&shown(name, &finding));
        all.push(finding);
    }
}

/// One kind for a while, or its few cases; the seeds that were run.
fn run_turn(
    kind: &Kind,
    count: &Count,
    plan: &Plan,
    turn: u64,
    findings: &Mutex<Vec<Finding>>,
) -> Range<u64> {
    let start = Instant::now();
    let first = plan.time.map_or(plan.seed, |_| {
        plan.seed.wrapping_add(turn.wrapping_mul(SEEDS_OF_A_TURN))
    });
    let mut end = first;
    // Where one kind is repeated from a seed, it begins with that seed.
    for i in 0..SEEDS_OF_A_TURN {
        let is_over = match plan.time {
            None => i >= kind.few,
            Some(Duration::ZERO) => i >= 1,
            Some(_) => start.elapsed() >= TURN,
        };
        if is_over && i > 0 {
            break;
        }
        end = first.wrapping_add(i + 1);
        match run_case(kind, first.wrapping_add(i)) {
            Ok(Outcome::Checked) => count.checked.fetch_add(1, Relaxed),
            Ok(Outcome::Open) => count.open.fetch_add(1, Relaxed),
            Err(finding) => {
                record(finding, plan.name, findings);
                count.failed.fetch_add(1, Relaxed)
            }
        };
    }
    let spent = start.elapsed().as_micros() as u64;
    count.microseconds.fetch_add(spent, Relaxed);
    first..end
}

#[test]
fn a_wrong_answer_is_a_finding_with_its_seed_and_input() {
    fn wrong(draw: &mut Draw) -> Outcome {
        let n = draw.below(1000);
        draw.input = format!("n = {n}");
        assert_eq!(n % 2, 0, "{n} is odd");
        Outcome::Checked
    }
    catch_panics_of_cases();
    let kind = Kind::new("wrong", Weight::Cheap, 1, wrong);
    let results: Vec<_> = (0..20).map(|seed| run_case(&kind, seed)).collect();
    let found: Vec<&Finding> = results.iter().filter_map(|r| r.as_ref().err()).collect();
    assert!((1..20).contains(&found.len()));
    for finding in found {
        let again = run_case(&kind, finding.seed).unwrap_err();
        assert_eq!(again.input, finding.input);
        assert!(again.differed.contains("is odd") && again.differed.contains("harness.rs"));
        assert!(shown("NAME", finding).contains(&format!("SEED={}", finding.seed)));
    }
}

#[test]
#[cfg(target_os = "linux")]
fn a_case_that_takes_much_memory_is_found_among_others() {
    fn large(draw: &mut Draw) -> Outcome {
        let n = draw.below(100);
        draw.input = format!("n = {n}");
        let size = if n == 7 {
            LARGEST_MEMORY + (64 << 20)
        } else {
            1
        };
        let bytes = vec![1_u8; size as usize];
        assert_eq!(bytes[bytes.len() / 2], 1);
        Outcome::Checked
    }
    let kind = Kind::new("large", Weight::Cheap, 1, large);
    let found = large_cases(&kind, 0..300);
    let drawn = (0..300).filter(|seed| Draw::new("large", *seed).below(100) == 7);
    assert_eq!(
        found.iter().map(|f| f.seed).collect::<Vec<_>>(),
        drawn.collect::<Vec<_>>()
    );
    assert!(!found.is_empty() && found.iter().all(|f| f.input == "n = 7"));
}
