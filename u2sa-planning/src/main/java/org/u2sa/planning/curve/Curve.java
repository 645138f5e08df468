package org.u2sa.planning.curve;

import java.util.ArrayList;
import java.util.List;

/**
 * A sequence of arcs and straights. Immutable.
 *
 * @param pieces in order
 */
public record Curve(List<Piece> pieces) {
  private static final double MAX_STEPS = 10_000.0; // per piece: erroneous goals may be anywhere

  /**
   * An arc or a straight.
   *
   * @param lengthM length [m]; negative in reverse
   * @param curvature curvature [1/m], right positive; 0 for a straight
   */
  public record Piece(double lengthM, double curvature) {}

  public Curve {
    pieces = List.copyOf(pieces);
  }

  /** Creates a curve from lengths in radii and directions: 1 right, 0 straight, −1 left. */
  static Curve of(double radiusM, double[] lengths, int[] senses) {
    if (!(radiusM > 0.0)) {
      throw new IllegalArgumentException("turn radius " + radiusM + " m: expected above 0");
    }
    List<Piece> pieces = new ArrayList<>();
    for (int i = 0; i < lengths.length; i++) {
      if (Math.abs(lengths[i]) > 1.0e-12) {
        pieces.add(new Piece(lengths[i] * radiusM, senses[i] / radiusM));
      }
    }
    return new Curve(pieces);
  }

  /** Total length, forward and reverse [m]. */
  public double lengthM() {
    double sum = 0.0;
    for (Piece piece : pieces) {
      sum += Math.abs(piece.lengthM());
    }
    return sum;
  }

  public Pose end(Pose start) {
    Pose pose = start;
    for (Piece piece : pieces) {
      pose = pose.along(piece.lengthM(), piece.curvature());
    }
    return pose;
  }

  /** A pose on the curve, and whether the vehicle reverses to it. */
  public record Sample(Pose pose, boolean backwards) {}

  /**
   * Samples poses on the curve, including the end of each piece but not the start.
   *
   * @param stepM maximum spacing [m], except of very long pieces
   */
  public List<Sample> sampled(Pose start, double stepM) {
    List<Sample> samples = new ArrayList<>();
    Pose from = start;
    for (Piece piece : pieces) {
      int steps =
          (int) Math.max(1.0, Math.min(MAX_STEPS, Math.ceil(Math.abs(piece.lengthM()) / stepM)));
      for (int k = 1; k <= steps; k++) {
        Pose pose = from.along(piece.lengthM() * k / steps, piece.curvature());
        samples.add(new Sample(pose, piece.lengthM() < 0.0));
      }
      from = from.along(piece.lengthM(), piece.curvature());
    }
    return samples;
  }
}
