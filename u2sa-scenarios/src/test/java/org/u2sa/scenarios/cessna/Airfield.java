package org.u2sa.scenarios.cessna;

import org.u2sa.messages.frame.Geodetic;

/**
 * A place to take off from, which no mission of the project uses: all hemispheres, high latitude,
 * both meridians where longitude or latitude change sign, and thin air.
 */
enum Airfield {
  WELLINGTON(174.8073, -41.3372, 12.0, 344.0),
  FIJI_BESIDE_THE_DATE_LINE(-179.9900, -16.6906, 67.0, 250.0),
  AKUREYRI(-18.0727, 65.6600, 2.0, 355.0),
  LONDON_CITY_BESIDE_GREENWICH(0.0447, 51.5048, 6.0, 273.0),
  LIBREVILLE_BESIDE_THE_EQUATOR(9.4123, 0.4686, 12.0, 157.0),
  USHUAIA(-68.2958, -54.8433, 31.0, 70.0),
  JOHANNESBURG_IN_THIN_AIR(27.9261, -25.9386, 1_378.0, 60.0),
  AVALON_BY_THE_DEAD_SEA(35.3886, 31.3281, -378.0, 10.0);

  private final double longitudeDeg;
  private final double latitudeDeg;
  private final double elevationM;
  private final double headingDeg;

  Airfield(double longitudeDeg, double latitudeDeg, double elevationM, double headingDeg) {
    this.longitudeDeg = longitudeDeg;
    this.latitudeDeg = latitudeDeg;
    this.elevationM = elevationM;
    this.headingDeg = headingDeg;
  }

  Geodetic place() {
    return new Geodetic(longitudeDeg, latitudeDeg, elevationM);
  }

  /** True, clockwise from north. */
  double headingDeg() {
    return headingDeg;
  }
}
