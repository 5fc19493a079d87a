//! Landings take no memory but what those before them have left.

use std::sync::Arc;

use crate::common::{level_scene, settings, table_4_1};
use allocation_counter::measure;
use touchdown_dynamics::batch::{Request, land_many};
use touchdown_dynamics::land::land;
use touchdown_dynamics::landing::Landing;
use touchdown_dynamics::scene::Scene;

/// Landings that rock back, topple, slide and bounce.
fn scenes() -> Vec<Scene> {
    (0..30)
        .map(|k| level_scene(180.0 - 6.0 * f64::from(k), 10.0, 4.0 + 0.6 * f64::from(k)))
        .collect()
}

#[test]
fn a_landing_allocates_nothing() {
    let vehicle = table_4_1();
    for tolerance in [3e-5, 1e-6] {
        let settings = settings(tolerance);
        for scene in scenes() {
            let mut landing: Option<Landing> = None;
            let used = measure(|| landing = Some(land(&vehicle, &scene, &settings)));
            assert!(landing.unwrap().events > 20);
            assert_eq!(used.count_total, 0, "{used:?}");
        }
    }
}

#[test]
fn batches_allocate_as_often_however_many_landings_there_are() {
    let vehicle = Arc::new(table_4_1());
    let scenes = scenes();
    let count = |landings: usize| {
        let mut keys = 0..landings;
        let mut done = 0;
        let used = measure(|| {
            let mut next = || {
                let key = keys.next()?;
                Some(Request {
                    key,
                    vehicle: Arc::clone(&vehicle),
                    scene: scenes[key % scenes.len()],
                    settings: settings(3e-5),
                })
            };
            land_many(&mut next, &mut |_, _| done += 1);
        });
        assert_eq!(done, landings);
        used.count_total
    };
    let few = count(20);
    assert!(few > 0);
    assert_eq!(count(100), few);
}
