package org.u2sa.sim.world;

import java.util.Comparator;
import java.util.List;
import java.util.function.Consumer;
import org.u2sa.messages.ObjectDescription;

/** Bounding-volume hierarchy of obstacles for fast ray casting. Immutable, built once per world. */
final class ObstacleTree {
  private final Bounds bounds;
  private final Leaf leaf; // null for inner nodes
  private final ObstacleTree one;
  private final ObstacleTree other;

  /** An object and its shape. */
  record Leaf(ObjectDescription object, Obstacle shape, Bounds bounds) {}

  private ObstacleTree(Bounds bounds, Leaf leaf, ObstacleTree one, ObstacleTree other) {
    this.bounds = bounds;
    this.leaf = leaf;
    this.one = one;
    this.other = other;
  }

  /**
   * @param leaves at least one
   */
  static ObstacleTree of(List<Leaf> leaves) {
    Bounds all = leaves.stream().map(Leaf::bounds).reduce(Bounds.NONE, Bounds::and);
    if (leaves.size() == 1) {
      return new ObstacleTree(all, leaves.get(0), null, null);
    }
    boolean wide = all.x1() - all.x0() > all.y1() - all.y0();
    List<Leaf> ordered =
        leaves.stream()
            .sorted(
                Comparator.comparingDouble(
                    wide
                        ? leaf -> leaf.bounds.x0() + leaf.bounds.x1()
                        : leaf -> leaf.bounds.y0() + leaf.bounds.y1()))
            .toList();
    int half = ordered.size() / 2;
    return new ObstacleTree(
        all, null, of(ordered.subList(0, half)), of(ordered.subList(half, ordered.size())));
  }

  /** Combines both trees. */
  ObstacleTree and(ObstacleTree more) {
    return new ObstacleTree(bounds.and(more.bounds), null, this, more);
  }

  /** Nearest hit of a ray, or the given one if it is closer. */
  Nearest nearest(Ray ray, Nearest soFar) {
    if (leaf != null) {
      double distance = leaf.shape.distanceM(ray);
      return distance < soFar.distanceM() ? new Nearest(distance, leaf.object) : soFar;
    }
    double toOne = one.bounds.enteredM(ray);
    double toOther = other.bounds.enteredM(ray);
    boolean inOrder = toOne <= toOther;
    Nearest nearest = soFar;
    if (Math.min(toOne, toOther) < nearest.distanceM()) {
      nearest = (inOrder ? one : other).nearest(ray, nearest);
    }
    if (Math.max(toOne, toOther) < nearest.distanceM()) {
      nearest = (inOrder ? other : one).nearest(ray, nearest);
    }
    return nearest;
  }

  /** A hit and its distance; the object is null for the ground or a miss. */
  record Nearest(double distanceM, ObjectDescription object) {}

  /** Whether an obstacle's bounding box intersects another. */
  boolean reaches(Bounds around) {
    return bounds.overlaps(around)
        && (leaf != null || one.reaches(around) || other.reaches(around));
  }

  /** Reports every obstacle a footprint touches. */
  void touched(Prism footprint, Bounds around, Consumer<ObjectDescription> found) {
    if (!bounds.overlaps(around)) {
      return;
    }
    if (leaf == null) {
      one.touched(footprint, around, found);
      other.touched(footprint, around, found);
    } else if (leaf.shape.touches(footprint)) {
      found.accept(leaf.object);
    }
  }
}
