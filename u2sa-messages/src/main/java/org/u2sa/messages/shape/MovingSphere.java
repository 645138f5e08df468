package org.u2sa.messages.shape;

import java.util.List;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.schema.MessageType;
import org.u2sa.messages.schema.NumberField;
import org.u2sa.messages.schema.Schema;
import org.u2sa.messages.schema.ValueField;

/**
 * A moving object, such as other traffic, at the centre of a keep-out sphere whose radius is the
 * separation distance (thesis 4.4.1.3). Its velocity is that of {@link #motion()}; if it is known
 * to turn, {@link #trajectory()} gives predicted positions.
 */
public class MovingSphere extends Sphere {
  private static final Schema<MovingSphere> SCHEMA =
      Schema.of(MovingSphere.class, MovingSphere::new, Sphere.TYPE).since(3);
  private static final NumberField<MovingSphere> TIME_STEP =
      SCHEMA.number("timeStep", "s", 1.0, 0.0);
  private static final ValueField<MovingSphere, List<Point>> TRAJECTORY =
      SCHEMA.points("trajectory", "m");

  public static final MessageType<MovingSphere> TYPE = SCHEMA.build();

  @Override
  public MessageType<? extends MovingSphere> type() {
    return TYPE;
  }

  /** Time step of the trajectory [s]. */
  public double timeStep() {
    return require(TIME_STEP);
  }

  public MovingSphere timeStep(double value) {
    return put(TIME_STEP, value);
  }

  /**
   * Predicted positions of the centre after one time step, two and so on, in the message's frame;
   * empty if only the velocity is known.
   */
  public List<Point> trajectory() {
    return require(TRAJECTORY);
  }

  public MovingSphere trajectory(List<Point> value) {
    return put(TRAJECTORY, value);
  }

  @Override
  public MovingSphere radius(double value) {
    return (MovingSphere) super.radius(value);
  }

  /**
   * Predicted position of the centre: along the trajectory, and at constant velocity beyond its end
   * or without one.
   *
   * @param seconds since the message's timestamp, not negative
   */
  public Point centerAfter(double seconds) {
    List<Point> points = trajectory();
    int passed = timeStep() > 0.0 ? (int) Math.min(points.size(), seconds / timeStep()) : 0;
    Point from = passed == 0 ? center() : points.get(passed - 1);
    double rest = seconds - passed * timeStep();
    if (passed == points.size() || timeStep() == 0.0) {
      return moved(from, motion().velocity().orElse(Point.ORIGIN), rest);
    }
    Point metres = metres(points.get(passed)).minus(metres(from));
    return moved(from, metres, rest / timeStep());
  }

  private Point moved(Point from, Point way, double share) {
    return metric().point(metres(from).plus(way.times(share)));
  }
}
