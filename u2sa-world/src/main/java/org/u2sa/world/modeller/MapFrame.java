package org.u2sa.world.modeller;

import java.util.Optional;
import org.u2sa.messages.Metric;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Attitude;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.frame.Rotation;
import org.u2sa.service.HandOver;

/**
 * The frame that a map is kept in, and an anchor, from which the map counts metres: in GLOBAL along
 * east, north, up, else along the frame's own axes. Immutable.
 */
public final class MapFrame {
  /** The map of a vehicle that does not know where it is: around the vehicle itself. */
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
   * The frame of a map that begins where the vehicle is: GLOBAL on the earth, anchored at the
   * vehicle; a local frame as it is, anchored at its origin.
   */
  public static MapFrame of(StateInformation vehicle) {
    ReferenceFrame frame = vehicle.referenceFrame();
    return frame.isEarth()
        ? new MapFrame(ReferenceFrame.GLOBAL, place(vehicle.in(ReferenceFrame.GLOBAL)))
        : new MapFrame(frame, Point.ORIGIN);
  }

  /** Says where a map is to be continued. */
  public void handOver(HandOver state) {
    state
        .text("MAP FRAME", frame.name())
        .number("ANCHOR X", anchor.x())
        .number("ANCHOR Y", anchor.y())
        .number("ANCHOR Z", anchor.z());
  }

  /** The frame of a map that somebody else began; empty if nobody did. */
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

  /** The frame of the map. */
  public ReferenceFrame frame() {
    return frame;
  }

  /** The point of the frame from which metres are counted. */
  public Point anchor() {
    return anchor;
  }

  /** A point of the frame as metres from the anchor. */
  public Point metres(Point point) {
    return metric.metres(point);
  }

  /** Metres from the anchor as a point of the frame. */
  public Point point(Point metres) {
    return metric.point(metres);
  }

  /** Whether states of this kind place things in this map. */
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
   * An object in this frame; empty if there is no way, as from LOCAL_NED to GLOBAL, from BODY for a
   * vehicle of unknown place, or for numbers that lead beyond all places.
   *
   * @param vehicle when the object was seen; empty: unknown
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
    } catch (IllegalArgumentException e) { // it would lie beyond all places
      return Optional.empty();
    }
  }

  private boolean joins(ObjectDescription object, StateInformation vehicle) {
    ReferenceFrame fixed = frame.isBody() ? object.referenceFrame() : frame;
    return !vehicle.referenceFrame().isBody()
        && fixed.isEarth() == vehicle.referenceFrame().isEarth();
  }

  /** The vehicle as metres from the anchor; the anchor itself in BODY. */
  public Point vehicle(Optional<StateInformation> vehicle) {
    if (frame.isBody() || vehicle.isEmpty()) {
      return Point.ORIGIN;
    }
    return metres(place(vehicle.get().in(frame)));
  }

  /** Turns the vehicle's FRD axes into the map's. */
  public Rotation mapFromFrd(Optional<StateInformation> vehicle) {
    if (frame.isBody() || vehicle.isEmpty()) {
      return Rotation.nedFromFrd(0.0, 0.0, 0.0);
    }
    StateInformation state =
        vehicle.get().in(frame.isEarth() ? ReferenceFrame.GLOBAL : ReferenceFrame.LOCAL_NED);
    Rotation nedFromFrd =
        new Attitude(state.phi().orElse(0.0), state.theta().orElse(0.0), state.psi().orElseThrow())
            .nedFromFrd();
    // Far from the anchor its north is not quite the vehicle's: 0.3 mrad at 5 km, which is left
    // out.
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
