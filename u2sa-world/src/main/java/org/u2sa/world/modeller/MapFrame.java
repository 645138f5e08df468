package org.u2sa.world.modeller;

import java.util.Optional;
import org.u2sa.messages.Metric;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Attitude;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.frame.Rotation;
import org.u2sa.service.handover.HandOver;

/**
 * Reference frame of a map, and an anchor from which map coordinates are measured in metres: along
 * east, north, up in GLOBAL, else along the frame's own axes. Immutable.
 */
public final class MapFrame {
  /** Frame of the map while the vehicle's pose is unknown: the vehicle itself. */
  public static final MapFrame BODY = new MapFrame(ReferenceFrame.BODY, Point.ORIGIN);

  private final ReferenceFrame frame;
  private final Point anchor;
  private final Metric metric;

  private MapFrame(ReferenceFrame frame, Point anchor) {
    this.frame = frame;
    this.anchor = anchor;
    metric = Metric.around(frame, anchor);
  }

  /**
   * Frame of a new map: GLOBAL, anchored at the vehicle, for geodetic states; otherwise the state's
   * local frame, anchored at its origin.
   */
  public static MapFrame of(StateInformation vehicle) {
    ReferenceFrame frame = vehicle.referenceFrame();
    return frame.isEarth()
        ? new MapFrame(ReferenceFrame.GLOBAL, place(vehicle.in(ReferenceFrame.GLOBAL)))
        : new MapFrame(frame, Point.ORIGIN);
  }

  public void handOver(HandOver state) {
    state
        .text("MAP FRAME", frame.name())
        .number("ANCHOR X", anchor.x())
        .number("ANCHOR Y", anchor.y())
        .number("ANCHOR Z", anchor.z());
  }

  /** Restores the frame of a predecessor; empty if none. */
  public static Optional<MapFrame> takenOver(HandOver state) {
    return state
        .text("MAP FRAME")
        .map(
            name ->
                new MapFrame(
                    ReferenceFrame.parse(name),
                    Point.of(
                        state.number("ANCHOR X").orElse(0.0),
                        state.number("ANCHOR Y").orElse(0.0),
                        state.number("ANCHOR Z").orElse(0.0))));
  }

  public ReferenceFrame frame() {
    return frame;
  }

  /** Origin of the map coordinates, in the frame. */
  public Point anchor() {
    return anchor;
  }

  /** Converts a point of the frame to metres from the anchor. */
  public Point metres(Point point) {
    return metric.metres(point);
  }

  /** Converts metres from the anchor to a point of the frame. */
  public Point point(Point metres) {
    return metric.point(metres);
  }

  /** Whether this vehicle state can be used in this map. */
  public boolean takes(StateInformation vehicle) {
    return frame.isEarth() == vehicle.referenceFrame().isEarth()
        && frame.isLocal() == vehicle.referenceFrame().isLocal();
  }

  /** +1 if the map's z axis points up, -1 if it points down. */
  public double up() {
    return frame.equals(ReferenceFrame.GLOBAL) || frame.equals(ReferenceFrame.LOCAL_ENU)
        ? 1.0
        : -1.0;
  }

  /**
   * Converts an object to this frame; empty if impossible, e.g. from LOCAL_NED to GLOBAL, from BODY
   * with an unknown vehicle pose, or if the coordinates overflow.
   *
   * @param vehicle vehicle state when the object was seen; empty if unknown
   */
  public Optional<ObjectDescription> placed(
      ObjectDescription object, Optional<StateInformation> vehicle) {
    if (object.referenceFrame().equals(frame)) {
      return Optional.of(object);
    }
    boolean between = object.referenceFrame().isBody() != frame.isBody();
    boolean sameFamily =
        object.referenceFrame().isEarth() == frame.isEarth()
            && object.referenceFrame().isLocal() == frame.isLocal();
    if (between ? vehicle.filter(each -> joins(object, each)).isEmpty() : !sameFamily) {
      return Optional.empty();
    }
    try {
      return Optional.of(object.in(frame, vehicle.orElse(null)));
    } catch (IllegalArgumentException e) { // coordinates out of range
      return Optional.empty();
    }
  }

  private boolean joins(ObjectDescription object, StateInformation vehicle) {
    ReferenceFrame fixed = frame.isBody() ? object.referenceFrame() : frame;
    return !vehicle.referenceFrame().isBody()
        && fixed.isEarth() == vehicle.referenceFrame().isEarth();
  }

  /** Vehicle position in metres from the anchor; in BODY, the anchor itself. */
  public Point vehicle(Optional<StateInformation> vehicle) {
    if (frame.isBody() || vehicle.isEmpty()) {
      return Point.ORIGIN;
    }
    return metres(place(vehicle.get().in(frame)));
  }

  /** Rotation from the vehicle's FRD axes to the map's. */
  public Rotation mapFromFrd(Optional<StateInformation> vehicle) {
    if (frame.isBody() || vehicle.isEmpty()) {
      return Rotation.nedFromFrd(0.0, 0.0, 0.0);
    }
    StateInformation state =
        vehicle.get().in(frame.isEarth() ? ReferenceFrame.GLOBAL : ReferenceFrame.LOCAL_NED);
    Rotation nedFromFrd =
        new Attitude(state.phi().orElse(0.0), state.theta().orElse(0.0), state.psi().orElseThrow())
            .nedFromFrd();
    // The anchor's north differs slightly from the vehicle's (0.3 mrad at 5 km); neglected.
    return frame.equals(ReferenceFrame.LOCAL_NED)
        ? nedFromFrd
        : Rotation.NED_FROM_ENU.times(nedFromFrd);
  }

  private static Point place(StateInformation state) {
    return Point.of(state.x().orElseThrow(), state.y().orElseThrow(), state.z().orElse(0.0));
  }

  @Override
  public String toString() {
    return frame + " about " + anchor;
  }
}
