package org.u2sa.sim.jsbsim;

import org.u2sa.sim.flight.UnmannedAircraft;

/** A simulated aircraft in JSBSim's format with its properties. Not thread-safe. */
public final class JsbsimFlight {
  private final UnmannedAircraft aircraft;
  private final JsbsimLoads loads;

  JsbsimFlight(UnmannedAircraft aircraft, JsbsimLoads loads) {
    this.aircraft = aircraft;
    this.loads = loads;
  }

  /** The aircraft, which its owner steps and commands. */
  public UnmannedAircraft aircraft() {
    return aircraft;
  }

  /** Value of a property of JSBSim in JSBSim's unit; 0 if the name is unknown. */
  public double property(String name) {
    return loads.property(name);
  }
}
