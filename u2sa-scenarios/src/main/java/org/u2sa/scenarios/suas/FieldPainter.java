package org.u2sa.scenarios.suas;

import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Random;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.Rotation;
import org.u2sa.sim.vehicle.VehicleTruth;

/**
 * Paints the camera's image of the field: grass with patches and pixel noise, and the targets,
 * averaging four rays per pixel. The grass is taken from one large picture at a different row in
 * each image, so it is not fixed to the ground unless a ground with its own colours is given.
 */
final class FieldPainter {
  private static final int[] GRASS = {92, 118, 62};
  private static final int PATCH_PX = 37;
  private static final int PATCH = 9; // brightness
  private static final double NOISE = 4.0; // standard deviation
  private static final int ROWS = 509; // possible offsets of an image in the grass picture
  private static final int EMPTY = 5; // different images without targets
  private static final double HORIZON = 0.05; // minimum downward component of a ray
  private static final double REACH = 0.75; // painted radius, as a share of a target's side

  private final List<SuasTarget> targets;
  private final SurveyPictures.Optics optics;
  private final byte[] grass;
  private final Map<Integer, byte[]> empty = new HashMap<>(); // images without targets
  private final Optional<FieldGround> ground;

  FieldPainter(List<SuasTarget> targets, SurveyPictures.Optics optics, long seed) {
    this(targets, optics, seed, Optional.empty());
  }

  FieldPainter(
      List<SuasTarget> targets,
      SurveyPictures.Optics optics,
      long seed,
      Optional<FieldGround> ground) {
    this.targets = targets;
    this.ground = ground;
    this.optics = optics;
    Random random = new Random(seed ^ 0x5DEECE66DL);
    int wide = optics.width();
    int high = optics.height() + ROWS;
    grass = new byte[3 * wide * high];
    int[] patches = new int[(wide / PATCH_PX + 1) * (high / PATCH_PX + 1)];
    for (int i = 0; i < patches.length; i++) {
      patches[i] = ground.isPresent() ? 0 : random.nextInt(2 * PATCH + 1) - PATCH;
    }
    for (int i = 0; i < wide * high; i++) {
      int patch = i / wide / PATCH_PX * (wide / PATCH_PX + 1) + i % wide / PATCH_PX;
      for (int c = 0; c < 3; c++) {
        double value = GRASS[c] + patches[patch] + NOISE * random.nextGaussian();
        grass[3 * i + c] = (byte) Math.max(0, Math.min(255, Math.round(value)));
      }
    }
  }

  byte[] picture(VehicleTruth truth) {
    int row = Math.floorMod(Math.round(1000.0 * truth.timeS()) * 7919L, ROWS);
    Point at = truth.position();
    double reachM = 3.0 * at.z();
    Optional<FieldGround> shown = ground.filter(each -> each.isSeenFrom(at));
    if (shown.isEmpty()
        && targets.stream()
            .noneMatch(
                each -> Math.hypot(each.eastM() - at.x(), each.northM() - at.y()) < reachM)) {
      return empty.computeIfAbsent(row % EMPTY, this::grassFrom);
    }
    byte[] pixels = grassFrom(row);
    Rotation nedFromFrd = truth.attitude().nedFromFrd();
    shown.ifPresent(each -> shade(each, nedFromFrd, at, pixels));
    for (SuasTarget target : targets) {
      paint(target, nedFromFrd, at, pixels);
    }
    return pixels;
  }

  private byte[] grassFrom(int row) {
    int from = 3 * row * optics.width();
    return Arrays.copyOfRange(grass, from, from + 3 * optics.width() * optics.height());
  }

  private void shade(FieldGround shown, Rotation nedFromFrd, Point at, byte[] pixels) {
    double focal = optics.focalPx();
    Point step = nedFromFrd.times(Point.of(0.0, 1.0 / focal, 0.0)); // change of the ray per column
    for (int row = 0; row < optics.height(); row++) {
      double v = row - 0.5 * (optics.height() - 1);
      Point first =
          nedFromFrd.times(Point.of(-v / focal, -0.5 * (optics.width() - 1) / focal, 1.0));
      double far = at.z();
      for (int column = 0; column < optics.width(); column++) {
        double down = first.z() + column * step.z();
        if (down > HORIZON) {
          double right = first.y() + column * step.y();
          double ahead = first.x() + column * step.x();
          far = shown.away(at, right / down, ahead / down, far);
          double east = at.x() + far * right / down;
          double north = at.y() + far * ahead / down;
          int i = 3 * (row * optics.width() + column);
          for (int c = 0; c < 3; c++) {
            int value = (pixels[i + c] & 0xff) + shown.shade(c, east, north);
            pixels[i + c] = (byte) Math.max(0, Math.min(255, value));
          }
        }
      }
    }
  }

  private void paint(SuasTarget target, Rotation nedFromFrd, Point at, byte[] pixels) {
    Point way = Point.of(target.northM() - at.y(), target.eastM() - at.x(), at.z() - target.upM());
    Point frd = nedFromFrd.transposed().times(way);
    double reachPx = optics.focalPx() * REACH * target.sideM() / way.z() + 3.0;
    double column = 0.5 * (optics.width() - 1) + optics.focalPx() * frd.y() / frd.z();
    double row = 0.5 * (optics.height() - 1) - optics.focalPx() * frd.x() / frd.z();
    if (frd.z() < 1.0 || !(reachPx < optics.width())) {
      return;
    }
    int top = (int) Math.max(0, row - reachPx);
    int bottom = (int) Math.min(optics.height() - 1, row + reachPx);
    int left = (int) Math.max(0, column - reachPx);
    int end = (int) Math.min(optics.width() - 1, column + reachPx);
    for (int y = top; y <= bottom; y++) {
      for (int x = left; x <= end; x++) {
        mix(target, nedFromFrd, at, x, y, pixels);
      }
    }
  }

  private void mix(SuasTarget target, Rotation nedFromFrd, Point at, int x, int y, byte[] pixels) {
    int i = 3 * (y * optics.width() + x);
    double[] sum = new double[3];
    for (int k = 0; k < 4; k++) {
      double u = x + 0.5 * (k % 2) - 0.25 - 0.5 * (optics.width() - 1);
      double v = y + 0.5 * (k / 2) - 0.25 - 0.5 * (optics.height() - 1);
      Point ray = nedFromFrd.times(Point.of(-v / optics.focalPx(), u / optics.focalPx(), 1.0));
      double far = (at.z() - target.upM()) / ray.z();
      int[] paint = target.paint(at.x() + far * ray.y(), at.y() + far * ray.x());
      for (int c = 0; c < 3; c++) {
        sum[c] += paint == null ? pixels[i + c] & 0xff : paint[c];
      }
    }
    for (int c = 0; c < 3; c++) {
      pixels[i + c] = (byte) Math.min(255, Math.round(sum[c] / 4.0));
    }
  }
}
