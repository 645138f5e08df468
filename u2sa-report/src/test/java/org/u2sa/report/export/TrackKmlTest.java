package org.u2sa.report.export;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.u2sa.interfaces.xml.XmlElement;
import org.u2sa.interfaces.xml.XmlReader;
import org.u2sa.report.score.Domain;
import org.u2sa.report.score.RunDetails;
import org.u2sa.report.score.RunOutcome;
import org.u2sa.report.score.RunPlan;
import org.u2sa.report.score.Track;
import org.u2sa.report.score.TrackSample;
import org.u2sa.report.summary.RunReport;

class TrackKmlTest {
  @TempDir private Path directory;

  /** Lines of the track and of the plan, of a run eastwards from a longitude. */
  private List<XmlElement> placemarks(double fromDeg) throws Exception {
    double toDeg = Math.IEEEremainder(fromDeg + 0.02, 360.0);
    Track track = new Track();
    for (int i = 0; i <= 20; i++) {
      double longitude = Math.IEEEremainder(fromDeg + 0.001 * i, 360.0);
      track.append(
          new TrackSample(
              i,
              longitude,
              10.0,
              5.0,
              Math.PI / 2.0,
              100.0,
              OptionalDouble.empty(),
              0,
              "",
              Optional.empty()));
    }
    RunPlan plan =
        new RunPlan(
            Domain.GROUND,
            Optional.of(new RunPlan.Start(fromDeg, 10.0, 5.0, Math.PI / 2.0)),
            List.of(
                new RunPlan.Waypoint(
                    "1", toDeg, 10.0, OptionalDouble.empty(), 5.0, OptionalDouble.empty())));
    RunReport.of(
            new RunDetails("rover", 1, "embedded", 1.0, OptionalInt.of(1)),
            plan,
            track,
            RunOutcome.clean())
        .write(directory);
    return XmlReader.read(directory.resolve("track.kml"), "kml")
        .children("Document")
        .get(0)
        .children("Placemark");
  }

  @Test
  void write_runOverTheAntimeridian_isCutThere() throws Exception {
    List<XmlElement> placemarks = placemarks(179.99);

    for (XmlElement line : placemarks.subList(0, 2)) {
      List<XmlElement> parts = line.children("MultiGeometry").get(0).children("LineString");
      assertThat(parts).hasSize(2);
      assertThat(parts.get(0).children("coordinates").get(0).text().strip())
          .startsWith("179.9900000,10.0000000,5.00")
          .endsWith("180.0000000,10.0000000,5.00");
      assertThat(parts.get(1).children("coordinates").get(0).text().strip())
          .startsWith("-180.0000000,10.0000000,5.00")
          .endsWith("-179.9900000,10.0000000,5.00");
    }
  }

  @Test
  void write_runElsewhere_isOneLine() throws Exception {
    assertThat(placemarks(8.0).get(0).children("LineString")).hasSize(1);
    assertThat(Files.readString(directory.resolve("track.kml"))).doesNotContain("MultiGeometry");
  }
}
