//! The command `land`: one landing, scene files and tables of cases.

pub mod cases;
pub mod land;
pub mod observed;
pub mod report;
pub mod scene_cases;
