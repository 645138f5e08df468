package org.u2sa.scenarios.suas;

import java.nio.file.Path;
import java.util.Locale;
import java.util.Random;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;
import org.u2sa.report.ReportFile;
import org.u2sa.sim.world.HeightMap;
import org.u2sa.sim.world.LocalPlane;
import org.u2sa.sim.world.Terrain;

/** Hills at a field's search area, which is level at the runway and the drop; and their map. */
final class SuasHills {
  private static final double SPAN_M = 3600.0;
  private static final int POINTS = 361; // points in each direction
  private static final double AROUND_M = 180.0; // distance from the area at which they end
  private static final double STRIP_M = 90.0; // level, beside the runway's axis
  private static final double DROP_M = 60.0; // level, around the drop
  private static final double ENDS_M = 120.0; // distance from level ground to the full height
  private static final int WAVES = 5;
  private static final double STEP_DEG = 1e-4; // of the map

  private final SuasField field;
  private final double[] norths = new double[WAVES]; // wave numbers [rad/m]
  private final double[] easts = new double[WAVES];
  private final double[] phases = new double[WAVES];

  private SuasHills(SuasField field) {
    this.field = field;
    Random random = new Random(field.seed() * 0x9E3779B97F4A7C15L + 17);
    for (int i = 0; i < WAVES; i++) {
      double length = 260.0 + 240.0 * random.nextDouble();
      double direction = 2.0 * Math.PI * random.nextDouble();
      norths[i] = 2.0 * Math.PI / length * Math.cos(direction);
      easts[i] = 2.0 * Math.PI / length * Math.sin(direction);
      phases[i] = 2.0 * Math.PI * random.nextDouble();
    }
  }

  /**
   * Draws hills.
   *
   * @param heightM maximum height from the deepest valley to the highest top
   */
  static Terrain of(SuasField field, double heightM) {
    SuasHills hills = new SuasHills(field);
    double[] heights = new double[POINTS * POINTS];
    double step = SPAN_M / (POINTS - 1);
    for (int i = 0; i < heights.length; i++) {
      double east = i % POINTS * step - 0.5 * SPAN_M;
      double north = 0.5 * SPAN_M - i / POINTS * step;
      heights[i] = heightM * hills.share(east, north);
    }
    return HeightMap.of(heights, POINTS, SPAN_M, SPAN_M);
  }

  private double share(double east, double north) {
    double sum = 0.0;
    for (int i = 0; i < WAVES; i++) {
      sum += Math.sin(easts[i] * east + norths[i] * north + phases[i]);
    }
    boolean inside = SuasField.isInside(field.searchArea(), east, north);
    double away = inside ? 0.0 : SuasField.edgeM(field.searchArea(), east, north);
    double alongX = Math.sin(field.runwayRad());
    double alongY = Math.cos(field.runwayRad());
    double aside = Math.abs(east * alongY - north * alongX);
    double drop = Math.hypot(east - field.drop().x(), north - field.drop().y());
    return (0.5 + 0.5 * sum / WAVES)
        * smooth(1.0 - away / AROUND_M)
        * smooth((aside - STRIP_M) / ENDS_M)
        * smooth((drop - DROP_M) / ENDS_M);
  }

  private static double smooth(double share) {
    double x = Math.max(0.0, Math.min(1.0, share));
    return x * x * (3.0 - 2.0 * x);
  }

  /** Writes the map that the aircraft is given, an Esri ASCII grid. */
  static Path write(SuasField field, Path file) {
    LocalPlane plane = SuasField.plane();
    Geodetic corner = plane.at(-0.49 * SPAN_M, -0.49 * SPAN_M, 0.0);
    Geodetic other = plane.at(0.49 * SPAN_M, 0.49 * SPAN_M, 0.0);
    int columns = (int) ((other.longitudeDeg() - corner.longitudeDeg()) / STEP_DEG);
    int rows = (int) ((other.latitudeDeg() - corner.latitudeDeg()) / STEP_DEG);
    StringBuilder text = new StringBuilder();
    text.append(
        String.format(
            Locale.ROOT,
            "ncols %d%nnrows %d%nxllcenter %.8f%nyllcenter %.8f%ncellsize %s%n",
            columns,
            rows,
            corner.longitudeDeg(),
            corner.latitudeDeg(),
            STEP_DEG));
    for (int row = rows - 1; row >= 0; row--) {
      for (int column = 0; column < columns; column++) {
        Geodetic place =
            new Geodetic(
                corner.longitudeDeg() + column * STEP_DEG,
                corner.latitudeDeg() + row * STEP_DEG,
                SuasField.ORIGIN.altitudeM());
        Point at = plane.point(place);
        double altitude = place.altitudeM() + field.ground().heightM(at.x(), at.y());
        text.append(String.format(Locale.ROOT, column == 0 ? "%.2f" : " %.2f", altitude));
      }
      text.append("\n");
    }
    ReportFile.writeText(file, out -> out.write(text.toString()));
    return file;
  }
}
