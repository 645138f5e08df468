package org.u2sa.gcs.mavlink.vehicle;

/**
 * Mode of the vehicle in the terms of ground stations.
 *
 * <p>{@link #GO_TO} is entered by a go-to order, never by name.
 */
public enum VehicleMode {
  HOLD("Hold", 0),
  MISSION("Mission", 6),
  RETURN("Return", 5),
  LAND("Land", 7),
  GO_TO("Go to", 0),
  MANUAL("Manual", 0);

  private final String label;
  private final int standard;

  VehicleMode(String label, int standard) {
    this.label = label;
    this.standard = standard;
  }

  /** Name for operators. */
  public String label() {
    return label;
  }

  /** MAV_STANDARD_MODE; 0 if no standard mode has this meaning. */
  public int standard() {
    return standard;
  }
}
