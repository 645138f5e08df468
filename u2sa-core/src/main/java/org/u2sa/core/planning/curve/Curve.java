package org.u2sa.core.planning.curve;

import java.util.ArrayList;
import java.util.List;

/**
 * Arcs and straights, one after the other. Immutable.
 *
 * @param pieces in order
 */
public record Curve(List<Piece> pieces) {
  /**
   * An arc or a straight.
   *
   * @param lengthM way on it [m]; negative backwards
   * @param curvature [1/m], to the right positive; 0 straight
   */
  public record Piece(double lengthM, double curvature) {}

  /** Copies the pieces. */
  public Curve {
    pieces = List.copyOf(pieces);
  }

  /** From lengths in radii and senses: 1 right, 0 straight, −1 left. */
  static Curve of(double radiusM, double[] lengths, int[] senses) {
    List<Piece> pieces = new ArrayList<>();
    for (int i = 0; i < lengths.length; i++) {
      if (Math.abs(lengths[i]) > 1.0e-12) {
        pieces.add(new Piece(lengths[i] * radiusM, senses[i] / radiusM));
      }
    }
    return new Curve(pieces);
  }

  /** Length of the way, whatever its direction [m]. */
  public double lengthM() {
    double sum = 0.0;
    for (Piece piece : pieces) {
      sum += Math.abs(piece.lengthM());
    }
    return sum;
  }

  /** Where it ends. */
  public Pose end(Pose start) {
    Pose pose = start;
    for (Piece piece : pieces) {
      pose = pose.along(piece.lengthM(), piece.curvature());
    }
    return pose;
  }

  /** A pose on the way, and whether the vehicle goes backwards to it. */
  public record Sample(Pose pose, boolean backwards) {}

  /**
   * Poses on the way, the end of each piece among them, the start not.
   *
   * @param stepM at most so far apart [m]
   */
  public List<Sample> sampled(Pose start, double stepM) {
    List<Sample> samples = new ArrayList<>();
    Pose from = start;
    for (Piece piece : pieces) {
      int steps = Math.max(1, (int) Math.ceil(Math.abs(piece.lengthM()) / stepM));
      for (int k = 1; k <= steps; k++) {
        Pose pose = from.along(piece.lengthM() * k / steps, piece.curvature());
        samples.add(new Sample(pose, piece.lengthM() < 0.0));
      }
      from = from.along(piece.lengthM(), piece.curvature());
    }
    return samples;
  }
}
