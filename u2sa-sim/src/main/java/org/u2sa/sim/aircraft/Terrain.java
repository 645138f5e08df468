package org.u2sa.sim.aircraft;

/** The ground below an aircraft; taken as level around the aircraft at each step. */
@FunctionalInterface
public interface Terrain {
  /** Elevation above mean sea level [m] at a WGS-84 position [°]. */
  double elevationM(double longitudeDeg, double latitudeDeg);

  /** Ground of one elevation everywhere. */
  static Terrain plane(double elevationM) {
    return (longitudeDeg, latitudeDeg) -> elevationM;
  }
}
