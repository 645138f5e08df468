package org.u2sa.scenarios.robosub.course;

import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.marine.Colour;
import org.u2sa.messages.marine.Pole;

/**
 * A gate of a red, a white and a green pole, to be passed on one side of the white pole.
 *
 * @param middle position of the white pole
 * @param across vector from there to the green pole
 * @param isLeft whether to pass on the side of the red pole
 */
record GateTask(Point middle, Point across, boolean isLeft) implements CourseTask {
  private static final String POLE = "pole";
  private static final double HEIGHT_M = 1.2; // of the poles

  private static ObjectDescription pole(Colour colour, Point at) {
    Pole pole = new Pole().colour(colour).radius(0.04).height(HEIGHT_M);
    return SubObjects.placed(pole, SubObjects.type(colour, POLE), at);
  }

  @Override
  public List<ObjectDescription> objects() {
    return List.of(
        pole(Colour.RED, middle.minus(across)),
        pole(Colour.WHITE, middle),
        pole(Colour.GREEN, middle.plus(across)));
  }

  @Override
  public List<Goal> goals() {
    String side = SubObjects.type(isLeft ? Colour.RED : Colour.GREEN, POLE);
    return List.of(
        new Goal("passGate", "gate", List.of(side, SubObjects.type(Colour.WHITE, POLE))));
  }

  @Override
  public SubTaskJudge judge() {
    return new Judge();
  }

  private final class Judge implements SubTaskJudge {
    private boolean isPassed;
    private boolean isWrongSide;

    @Override
    public Optional<String> moved(Point from, Point to) {
      double width = Math.hypot(across.x(), across.y());
      Point unit = across.times(1.0 / width);
      Point off = to.minus(middle);
      double aside = off.x() * unit.x() + off.y() * unit.y();
      boolean isInside = Math.abs(aside) < width && Math.abs(off.z()) < HEIGHT_M / 2.0;
      if (isPassed || isWrongSide || !isInside || beyond(from) >= 0.0 || beyond(to) < 0.0) {
        return Optional.empty();
      }
      isPassed = isLeft == aside < 0.0;
      isWrongSide = !isPassed;
      return Optional.of(
          String.format(Locale.ROOT, "gate passed, %+.2f m from its divider", aside));
    }

    /** Positive beyond the plane of the gate. */
    private double beyond(Point at) {
      Point off = at.minus(middle);
      return off.x() * across.y() - off.y() * across.x();
    }

    @Override
    public Optional<String> violation() {
      return isPassed
          ? Optional.empty()
          : Optional.of(isWrongSide ? "gate: passed on the wrong side" : "gate: not passed");
    }

    @Override
    public Map<String, Integer> counts() {
      return Map.of("gatesPassed", isPassed ? 1 : 0);
    }
  }
}
