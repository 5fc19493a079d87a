//! Tests of whole landings and of the equations behind them, in one program.

mod common;

mod allocations;
mod any_scene;
mod attitude;
mod batch;
mod center_of_gravity_offset;
mod closed_forms;
mod conservation;
mod contact;
mod convergence;
mod early_end;
mod equations;
mod extremes;
mod footing;
mod footpad_edge;
mod ground;
mod honeycomb;
mod impact_surface;
mod laws;
mod methods_of_1966;
mod reference_histories;
mod reference_landings;
mod reference_transitions;
mod report_integrator;
mod response;
mod rest;
mod rigid_polygon;
mod sample_run;
mod soil;
mod symmetry;
mod table_4_3;
mod three_struts;
mod thrust;
