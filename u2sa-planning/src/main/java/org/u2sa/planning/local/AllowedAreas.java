package org.u2sa.planning.local;

import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.safety.FenceState;
import org.u2sa.messages.shape.Polygon;
import org.u2sa.planning.guidance.Leg;
import org.u2sa.planning.seen.PlanarShape;
import org.u2sa.planning.seen.SeenWorld;

/** Areas of the fence in force, on the planning plane. Confined to the planner's thread. */
public final class AllowedAreas {
  private final SeenWorld world;
  private Optional<FenceState> fence = Optional.empty();

  /** Without a fence yet: everything is allowed. */
  public AllowedAreas(SeenWorld world) {
    this.world = world;
  }

  /** Receives the fence in force. */
  public void see(FenceState inForce) {
    fence = Optional.of(inForce);
  }

  /**
   * Area inside the fence in force, drawn once, for many questions around a position; empty if a
   * fence of another frame is in force.
   *
   * @param at position on the plane [m]
   */
  public Area area(Point at, StateInformation state) {
    List<Polygon> keepIn = fence.map(FenceState::keepIn).orElse(List.of());
    List<Polygon> keepOut = fence.map(FenceState::keepOut).orElse(List.of());
    boolean onEarth = world.plane(state).onEarth();
    boolean isForeign =
        Stream.concat(keepIn.stream(), keepOut.stream())
            .map(Polygon::referenceFrame)
            .anyMatch(frame -> onEarth ? !frame.equals(ReferenceFrame.GLOBAL) : !frame.isLocal());
    return isForeign
        ? new Area.Uniform(false)
        : new Inside(outlines(keepIn, state), outlines(keepOut, state), at);
  }

  private List<PlanarShape> outlines(List<Polygon> areas, StateInformation state) {
    return areas.stream().map(area -> world.outline(area, state)).collect(Collectors.toList());
  }

  /** Inside one of the outer areas, if there are any, and outside the inner ones. */
  private static final class Inside implements Area {
    private static final double STEP_M = 1.0; // of a way through several outer areas
    private static final double FIRST_M = 0.5; // part of a way that must lead nearer

    private final List<PlanarShape> outer;
    private final List<PlanarShape> inner;
    private final Point middle;
    private final boolean isMiddleInside;
    private final double edgeM; // distance of the middle from the nearest edge

    Inside(List<PlanarShape> outer, List<PlanarShape> inner, Point middle) {
      this.outer = outer;
      this.inner = inner;
      this.middle = middle;
      isMiddleInside = isInside(middle.x(), middle.y());
      edgeM = edgeM(middle.x(), middle.y());
    }

    /** Distance to the nearest edge of any area [m]. */
    private double edgeM(double northM, double eastM) {
      return Stream.concat(outer.stream(), inner.stream())
          .mapToDouble(each -> edgeM(each, northM, eastM))
          .min()
          .orElse(Double.POSITIVE_INFINITY);
    }

    @Override
    public double roomM(double northM, double eastM) {
      return isInside(northM, eastM) ? edgeM(northM, eastM) : -outsideM(northM, eastM);
    }

    @Override
    public boolean contains(double northM, double eastM) {
      return isNear(northM, eastM) ? isMiddleInside : isInside(northM, eastM);
    }

    private boolean isNear(double northM, double eastM) {
      return Math.hypot(northM - middle.x(), eastM - middle.y()) < edgeM;
    }

    private boolean isInside(double northM, double eastM) {
      return (outer.isEmpty() || outer.stream().anyMatch(area -> area.isInside(northM, eastM)))
          && inner.stream().noneMatch(area -> area.isInside(northM, eastM));
    }

    @Override
    public boolean allows(double northM, double eastM, double toNorthM, double toEastM) {
      if (isMiddleInside && isNear(northM, eastM) && isNear(toNorthM, toEastM)) {
        return true;
      }
      if (!contains(northM, eastM)) {
        return leadsBack(northM, eastM, toNorthM, toEastM);
      }
      return contains(toNorthM, toEastM)
          && inner.stream().noneMatch(area -> area.isCrossedBy(northM, eastM, toNorthM, toEastM))
          && staysIn(northM, eastM, toNorthM, toEastM);
    }

    /** Whether a way from outside ends nearer, and leads there at once: not through the area. */
    private boolean leadsBack(double northM, double eastM, double toNorthM, double toEastM) {
      double wayM = Math.hypot(toNorthM - northM, toEastM - eastM);
      double share = Math.min(1.0, FIRST_M / Math.max(FIRST_M, wayM));
      double firstM =
          outsideM(northM + share * (toNorthM - northM), eastM + share * (toEastM - eastM));
      double hereM = outsideM(northM, eastM);
      return firstM < hereM && outsideM(toNorthM, toEastM) < hereM;
    }

    private boolean staysIn(double northM, double eastM, double toNorthM, double toEastM) {
      if (outer.stream().noneMatch(area -> area.isCrossedBy(northM, eastM, toNorthM, toEastM))) {
        return true;
      }
      double wayM = Math.hypot(toNorthM - northM, toEastM - eastM);
      int steps = outer.size() == 1 ? 0 : (int) Math.ceil(wayM / STEP_M); // one has been left
      boolean stays = steps > 0;
      for (int i = 1; i < steps && stays; i++) {
        double share = (double) i / steps;
        stays = contains(northM + share * (toNorthM - northM), eastM + share * (toEastM - eastM));
      }
      return stays;
    }

    /** Distance to the area; 0 inside [m]. */
    private double outsideM(double northM, double eastM) {
      double fromOuterM =
          outer.stream()
              .mapToDouble(area -> area.isInside(northM, eastM) ? 0.0 : edgeM(area, northM, eastM))
              .min()
              .orElse(0.0);
      double intoInnerM =
          inner.stream()
              .filter(area -> area.isInside(northM, eastM))
              .mapToDouble(area -> edgeM(area, northM, eastM))
              .max()
              .orElse(0.0);
      return Math.max(fromOuterM, intoInnerM);
    }

    private static double edgeM(PlanarShape outline, double northM, double eastM) {
      double leastM = Double.POSITIVE_INFINITY;
      for (int i = 0; i < outline.count(); i++) {
        int next = (i + 1) % outline.count();
        Leg edge =
            new Leg(outline.northM(i), outline.eastM(i), outline.northM(next), outline.eastM(next));
        leastM = Math.min(leastM, edge.distanceM(northM, eastM));
      }
      return leastM;
    }
  }
}
