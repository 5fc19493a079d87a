//! The command `land`: one landing, scene files and tables of cases.

pub mod cases;
pub mod integration_report;
pub mod land;
pub mod land_files;
pub mod land_while;
pub mod report;
pub mod scene_cases;
