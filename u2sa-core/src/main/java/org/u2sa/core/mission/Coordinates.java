package org.u2sa.core.mission;

import org.u2sa.interfaces.xml.XmlElement;

/** Limits of coordinates on the earth. */
final class Coordinates {
  private Coordinates() {}

  static void checkLongitude(XmlElement element, double longitudeDeg) {
    Numbers.within(element, longitudeDeg, -180.0, 180.0, "deg of longitude");
  }

  static void checkLatitude(XmlElement element, double latitudeDeg) {
    Numbers.within(
        element, latitudeDeg, -90.0, 90.0, "deg of latitude (x is longitude, y is latitude)");
  }
}
