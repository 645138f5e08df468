package org.u2sa.report.export;

import java.io.IOException;
import java.io.Writer;
import java.util.Locale;
import java.util.OptionalDouble;
import org.u2sa.report.EscapedXml;

/** What the KML 2.2 files of runs have in common: head, end, points. */
final class KmlDocument {
  static final String ON_THE_GROUND = "clampToGround";
  static final String AT_ALTITUDE = "absolute";

  private KmlDocument() {}

  /** Writes all before the first place; KML's colours are alpha, blue, green, red. */
  static void begin(Writer out, String title, String styles) throws IOException {
    out.write(
        """
        <?xml version="1.0" encoding="UTF-8"?>
        <kml xmlns="http://www.opengis.net/kml/2.2" xmlns:gx="http://www.google.com/kml/ext/2.2">
        <Document>
          <name>%s</name>
        %s"""
            .formatted(EscapedXml.of(title), styles.indent(2)));
  }

  /** Writes a point; altitude above mean sea level [m], empty: on the ground. */
  static void point(
      Writer out,
      String name,
      String description,
      double longitudeDeg,
      double latitudeDeg,
      OptionalDouble altitudeM)
      throws IOException {
    out.write(
        String.format(
            Locale.ROOT,
            "  <Placemark><name>%s</name><description>%s</description><Point>"
                + "<altitudeMode>%s</altitudeMode><coordinates>%.9f,%.9f,%.3f</coordinates></Point></Placemark>\n",
            EscapedXml.of(name),
            description,
            altitudeM.isPresent() ? AT_ALTITUDE : ON_THE_GROUND,
            longitudeDeg,
            latitudeDeg,
            altitudeM.orElse(0.0)));
  }

  static void end(Writer out) throws IOException {
    out.write("</Document>\n</kml>\n");
  }
}
