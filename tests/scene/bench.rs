//! References and comparisons: what is right to thirty digits, and what is measured against it.

use polhode::bench::{
    Contender, Problem, axes, calibrate, cells, ensemble, floor, held, measure, problems, reference,
};
use polhode::motion::FreeBody;
use polhode::scene::{Run, Way, angle, distance, size, way};
use std::time::Duration;

fn problem(name: &str) -> Problem {
    let mut all = problems().expect("bodies");
    let at = all.iter().position(|p| p.name == name).expect("a problem");
    let mut found = all.swap_remove(at);
    // Thirty digits take their time in a debug build.
    found.duration = found.duration.min(2.0);
    found
}

#[test]
fn the_reference_of_a_free_body_is_its_closed_form() {
    for name in ["free", "separatrix"] {
        let p = problem(name);
        let truth = reference(&p.member, &[0.5 * p.duration, p.duration]).expect("a motion");
        let exact = FreeBody::new(&p.member.body, &p.member.start);
        for (part, state) in [0.5, 1.0].iter().zip(&truth) {
            let other = exact.at(part * p.duration).expect("finite");
            let off = distance(state, &other, size(&p.member.start.angular_velocity));
            assert!(off < 1e-13, "{name}: {off:e}");
        }
    }
}

#[test]
fn every_method_comes_near_the_truth_and_finer_is_nearer() {
    let p = problem("top");
    let truth = reference(&p.member, &[p.duration]).expect("a motion")[0];
    let error = |contender, setting| measure(&p, contender, setting, &truth, Duration::ZERO).error;
    for contender in [
        Contender::Taylor,
        Contender::Dop853,
        Contender::RivalDop853,
        Contender::RivalDopri5,
    ] {
        let (rough, fine) = (error(contender, 1e-4), error(contender, 1e-10));
        assert!(
            rough < 1e-1 && fine < 1e-7 && fine < rough,
            "{contender:?}: {rough:e}, {fine:e}"
        );
    }
    for contender in [
        Contender::Rk4,
        Contender::Splitting,
        Contender::Midpoint,
        Contender::MoserVeselov,
    ] {
        let (rough, fine) = (error(contender, 0.2), error(contender, 0.02));
        assert!(
            fine < 1e-2 && fine < 0.2 * rough,
            "{contender:?}: {rough:e}, {fine:e}"
        );
    }
    let single = error(Contender::Rk4Single, 0.02);
    assert!((1e-8..1e-3).contains(&single), "{single:e}");
    assert!(!Contender::Exact.takes(&p.member));
    let points = vec![measure(&p, Contender::Plan, 1e-9, &truth, Duration::ZERO)];
    assert!(floor(&points, "top", Contender::Plan).is_some_and(|least| least < 1e-9));
}

#[test]
fn what_methods_cost_is_measured() {
    let costs = calibrate(Duration::ZERO).expect("bodies");
    for five in [
        costs.taylor,
        costs.taylor_space,
        costs.dop853,
        costs.dop853_space,
    ] {
        assert!(
            five.iter().all(|cost| *cost > 1.0 && cost.is_finite()),
            "{five:?}"
        );
    }
    // Whatever the machine: more digits cost a method of fixed order more.
    assert!(costs.dop853[4] > costs.dop853[1] && costs.spin > 0.0 && costs.rk4 > 0.0);
}

#[test]
fn the_closed_form_holds_on_every_axis() {
    for axis in axes(1e2).expect("bodies") {
        let found =
            cells(&axis, &[Contender::Exact, Contender::Taylor], &mut || ()).expect("a map");
        let (_, lost) = held(&found, axis.name, Contender::Exact, 1e-9);
        assert!(lost.is_empty(), "{}: {lost:?}", axis.name);
    }
}

/// A run of a case of the map by a plan that knows nothing of it but the member.
fn planned(problem: &Problem) -> Way {
    let run = Run::to_the_end(problem.duration, 1e-9);
    way(&problem.member, &run).expect("a plan")
}

#[test]
fn the_plan_keeps_to_the_map() {
    let steppers = [Contender::Taylor, Contender::Dop853];
    let (mut within, mut beyond) = (0, 0);
    for axis in axes(1e2).expect("bodies") {
        // Thirty digits take their time in a debug build.
        if cfg!(debug_assertions) && axis.name != "damped spin" {
            continue;
        }
        let found = cells(&axis, &steppers, &mut || ()).expect("a map");
        for (value, problem) in &axis.cases {
            let reaches = |c: &Contender| {
                let reach = c.reach().expect("it steps");
                reach.holds(&problem.member, angle(&problem.member, problem.duration))
            };
            // Where the plan may use a method, the method holds.
            for contender in steppers.iter().filter(|c| reaches(c)) {
                let (_, lost) = held(&found, axis.name, *contender, 1e-6);
                assert!(
                    !lost.iter().any(|at| at.total_cmp(value).is_eq()),
                    "{contender:?} is lost at {} {value:e}",
                    axis.name
                );
                within += 1;
            }
            // Where it may use but one, it uses that one.
            let may: Vec<_> = steppers.iter().filter(|c| reaches(c)).collect();
            if let ([only], Way::Taylor { .. } | Way::Dop853 { .. }) = (&may[..], planned(problem))
            {
                let is_taylor = matches!(planned(problem), Way::Taylor { .. });
                assert_eq!(
                    is_taylor,
                    **only == Contender::Taylor,
                    "{} {value:e}",
                    axis.name
                );
                beyond += 1;
            }
        }
    }
    assert!(
        within > 8 && beyond > 0,
        "{within} within, {beyond} for one method alone"
    );
}

#[test]
fn an_ensemble_keeps_its_tolerance() {
    let found = ensemble(3, 1e-9).expect("tops");
    assert_eq!(found.len(), 3);
    for of in found {
        assert!(of.error <= 1e-9 && of.seconds.is_finite(), "{of:?}");
    }
}
