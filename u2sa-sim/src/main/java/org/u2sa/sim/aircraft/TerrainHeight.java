package org.u2sa.sim.aircraft;

/** The ground below an aircraft; taken as level around the aircraft at each step. */
@FunctionalInterface
public interface TerrainHeight {
  /** Elevation above mean sea level [m] at a WGS-84 position [°]. */
  double elevationM(double longitudeDeg, double latitudeDeg);

  /** Ground of one elevation everywhere. */
  static TerrainHeight plane(double elevationM) {
    return (longitudeDeg, latitudeDeg) -> elevationM;
  }
}
