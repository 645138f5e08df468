package org.u2sa.world.object;

import java.util.ArrayList;
import java.util.List;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.shape.MovingSphere;
import org.u2sa.world.modeller.MapFrame;

/** Converts tracks to messages; moving objects become moving spheres (thesis 4.4.1.3). */
final class TrackReport {
  private static final double STEP_S = 1.0;

  ObjectDescription of(
      MappedObject track, MapFrame frame, ObjectMapVariables settings, long micros) {
    ObjectDescription object =
        track.filter().isMoving() && !track.isFromFile()
            ? moving(track, frame, settings)
            : track.isFromFile() ? track.template().copy() : estimate(track, frame);
    object.uid(track.uid()).confidence(track.existence());
    object.timestamp(micros);
    return object;
  }

  /** Creates the object in its own shape at its estimated position. */
  ObjectDescription estimate(MappedObject track, MapFrame frame) {
    ObjectDescription object = track.template().movedTo(frame.point(track.place()));
    object.uid(track.uid()).confidence(track.existence());
    object.motion().sigma(track.filter().sigma());
    if (track.filter().isMoving()) {
      object
          .motion()
          .velocity(track.filter().velocity())
          .velocitySigma(track.filter().velocitySigma());
    } else if (track.hasMoved() || object.motion().velocity().isPresent()) {
      object.motion().velocity(Point.ORIGIN); // stationary now, but may move again
    }
    return object;
  }

  private static ObjectDescription moving(
      MappedObject track, MapFrame frame, ObjectMapVariables settings) {
    MovingSphere sphere = new MovingSphere().radius(track.radius() + settings.buffer());
    Point center = frame.point(track.place());
    sphere
        .objectType(track.template().objectType())
        .referenceFrame(frame.frame())
        .x(center.x())
        .y(center.y())
        .z(center.z())
        .sensorName(track.template().sensorName());
    track.template().level().ifPresent(sphere::level);
    sphere
        .motion()
        .velocity(track.filter().velocity())
        .velocitySigma(track.filter().velocitySigma())
        .sigma(track.filter().sigma())
        .horizon(settings.horizon());
    Point velocity = track.filter().velocity();
    List<Point> way = new ArrayList<>();
    for (double t = STEP_S; t <= settings.horizon(); t += STEP_S) {
      way.add(
          frame.point(
              track.place().plus(Point.of(t * velocity.x(), t * velocity.y(), t * velocity.z()))));
    }
    return sphere.timeStep(STEP_S).trajectory(way);
  }
}
