package org.u2sa.scenarios.suas;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;
import org.u2sa.report.mosaic.SurveyMosaic;
import org.u2sa.sim.world.LocalPlane;

/** Compares a mosaic with the true ground: colours, and positions of the targets. */
final class MosaicScore {
  private static final int CHANNELS = 3;
  private static final double TARGET_M = 4.0; // radius around a target's true position
  private static final int STANDS_OUT = 90; // sum of the differences of red, green and blue

  private final SurveyMosaic mosaic;
  private final List<Point> area;
  private final List<SuasTarget> targets;
  private final FieldGround ground;
  private final LocalPlane plane = SuasField.plane();
  private long pixels; // in the search area
  private long seen;
  private double errors;
  private final double[][] shown; // of each target as shown: sums of weight, east, north
  private final double[][] truth; // the same in the true ground

  private MosaicScore(
      SurveyMosaic mosaic, List<Point> area, List<SuasTarget> targets, FieldGround ground) {
    this.mosaic = mosaic;
    this.area = area;
    this.targets = targets;
    this.ground = ground;
    shown = new double[targets.size()][CHANNELS];
    truth = new double[targets.size()][CHANNELS];
  }

  /**
   * Metrics: fraction of the area that is shown, mean colour error, largest offset of a target.
   *
   * @param area corners of the search area, east and north of the field's middle [m]
   */
  static Map<String, Double> of(
      SurveyMosaic mosaic, List<Point> area, List<SuasTarget> targets, FieldGround ground) {
    return new MosaicScore(mosaic, area, targets, ground).figures();
  }

  private Map<String, Double> figures() {
    for (int row = 0; row < mosaic.grid().rows(); row++) {
      for (int column = 0; column < mosaic.grid().columns(); column++) {
        Geodetic place = mosaic.place(column, row);
        Point at = plane.point(place);
        if (SuasField.isInside(area, at.x(), at.y())) {
          pixels++;
          compare(mosaic.picture().getRGB(column, row), at);
        }
      }
    }
    double worst = 0.0;
    for (int i = 0; i < shown.length; i++) {
      double east = shown[i][1] / shown[i][0] - truth[i][1] / truth[i][0];
      double north = shown[i][2] / shown[i][0] - truth[i][2] / truth[i][0];
      worst = Math.max(worst, Math.hypot(east, north));
    }
    Map<String, Double> figures = new LinkedHashMap<>();
    figures.put("mosaicShown", pixels == 0 ? 0.0 : (double) seen / pixels);
    figures.put("mosaicColourError", seen == 0 ? 255.0 : errors / seen / CHANNELS);
    figures.put("mosaicTargetOffsetM", Double.isNaN(worst) ? 999.0 : worst);
    return figures;
  }

  private void compare(int argb, Point at) {
    boolean isSeen = argb >>> 24 != 0;
    seen += isSeen ? 1 : 0;
    int contrast = 0;
    int trueContrast = 0;
    for (int c = 0; c < CHANNELS; c++) {
      int colour = argb >> 8 * (2 - c) & 0xff;
      int exact = ground.colour(c, at);
      int bare = ground.bare(c, at.x(), at.y());
      errors += isSeen ? Math.abs(colour - exact) : 0.0;
      contrast += isSeen ? Math.abs(colour - bare) : 0;
      trueContrast += Math.abs(exact - bare);
    }
    for (int i = 0; i < shown.length; i++) {
      SuasTarget target = targets.get(i);
      if (Math.hypot(target.eastM() - at.x(), target.northM() - at.y()) < TARGET_M) {
        add(shown[i], contrast, at);
        add(truth[i], trueContrast, at);
      }
    }
  }

  private static void add(double[] sums, int contrast, Point at) {
    if (contrast > STANDS_OUT) {
      sums[0] += 1.0;
      sums[1] += at.x();
      sums[2] += at.y();
    }
  }
}
