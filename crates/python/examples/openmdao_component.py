"""The transition velocity as a component of OpenMDAO, and a small trade with it: ``python openmdao_component.py``."""

from __future__ import annotations

from typing import Any

import openmdao.api as om

import touchdown as td

SCENE = td.Scene(vertical_velocity_fps=14, cross_slope_deg=180, slope_deg=15, friction=1.0)
SEARCH = {"bands": "first", "from_fps": 6, "to_fps": 16, "scan_step_fps": 1, "tolerance_fps": 0.001}


class FirstTransition(om.ExplicitComponent):
    """V_H of first transition over two numbers of all struts."""

    def initialize(self) -> None:
        self.options.declare("vehicle", types=td.Vehicle, desc="what lands")
        self.options.declare("scene", types=td.Scene, desc="how it touches down")
        self.options.declare("search", types=dict, desc="where V_H is searched, as a table [search]")

    def setup(self) -> None:
        strut = self.options["vehicle"].to_dict()["strut"]
        self.add_input("preload", strut["preload_lb"], units="lbf")
        self.add_input("rebound_damping", strut["rebound_damping"], units="lbf*s**2/ft**2")
        self.add_output("first_transition", units="ft/s")
        # V_H is known to the tolerance of the search, so steps are long: 5 % of the input.
        self.declare_partials("*", "*", method="fd", form="central", step=0.05, step_calc="rel")

    def compute(self, inputs: Any, outputs: Any) -> None:
        vehicle = self.options["vehicle"].replace(
            {"strut.preload_lb": inputs["preload"].item(), "strut.rebound_damping": inputs["rebound_damping"].item()}
        )
        found = td.boundary(vehicle, self.options["scene"], search=self.options["search"], progress=False)
        if found.first_transition_fps is None:
            raise om.AnalysisError("all landings of the search are stable: there is no transition")
        outputs["first_transition"] = found.first_transition_fps


def problem() -> om.Problem:
    """The highest V_H within what the struts may be."""
    made = om.Problem(reports=False)
    component = FirstTransition(vehicle=td.vehicles.surveyor(), scene=SCENE, search=SEARCH)
    made.model.add_subsystem("landing", component, promotes=["*"])
    made.model.add_design_var("preload", lower=100, upper=300, ref=300)
    made.model.add_design_var("rebound_damping", lower=400, upper=1200, ref=1200)
    made.model.add_objective("first_transition", scaler=-1)
    made.driver = om.ScipyOptimizeDriver(optimizer="COBYLA", tol=0.02, maxiter=30, disp=False)
    made.setup()
    return made


def main() -> None:
    trade = problem()
    trade.run_model()
    print(f"as built: V_H = {trade.get_val('first_transition', units='m/s').item():.3f} m/s")
    for (_, name), slope in trade.compute_totals().items():
        print(f"  for 10 % more {name}: {slope.item() * 0.1 * trade.get_val(name).item():+.3f} ft/s")
    trade.run_driver()
    print(f"best:     V_H = {trade.get_val('first_transition', units='m/s').item():.3f} m/s")
    print(f"  preload {trade.get_val('preload', units='N').item():.0f} N")
    print(f"  rebound damping {trade.get_val('rebound_damping', units='N*s**2/m**2').item():.0f} N s2/m2")


if __name__ == "__main__":
    main()
