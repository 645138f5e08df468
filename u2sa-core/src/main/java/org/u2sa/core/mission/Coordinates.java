package org.u2sa.core.mission;

import org.u2sa.interfaces.xml.XmlElement;

/** Limits of coordinates on the earth. */
public final class Coordinates {
  private Coordinates() {}

  /** Refuses what is no longitude. */
  public static void checkLongitude(XmlElement element, double longitudeDeg) {
    MissionNumbers.within(element, longitudeDeg, -180.0, 180.0, "deg of longitude");
  }

  /** Refuses what is no latitude. */
  public static void checkLatitude(XmlElement element, double latitudeDeg) {
    MissionNumbers.within(
        element, latitudeDeg, -90.0, 90.0, "deg of latitude (x is longitude, y is latitude)");
  }
}
