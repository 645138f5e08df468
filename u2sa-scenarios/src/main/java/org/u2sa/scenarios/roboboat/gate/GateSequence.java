package org.u2sa.scenarios.roboboat.gate;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import org.u2sa.messages.frame.Point;

/** The known gates of a channel: those passed, and the next one. */
public final class GateSequence {
  private static final double SAME_M = 2.0; // gates this close are the same
  private static final double BEHIND_M = 1.0; // minimum distance to a gate still ahead
  private static final double REACH_M = 30.0; // maximum distance to the next gate
  private static final double KEPT_M = 4.0; // closer gates are kept if a buoy is lost

  private final List<Point> passed = new ArrayList<>(); // centres of the gates passed
  private List<Gate> gates = List.of(); // newest
  private Optional<Point> before = Optional.empty(); // position of the boat at the last state
  private Optional<Gate> last = Optional.empty();
  private Optional<Gate> aimed = Optional.empty(); // gate to be passed, as of the last state

  public void begin() {
    passed.clear();
    before = Optional.empty();
    last = Optional.empty();
    aimed = Optional.empty();
  }

  /** Returns whether the boat has passed a gate since the last call. */
  public boolean move(List<Gate> seen, Point here) {
    gates = new ArrayList<>(seen);
    aimed
        .filter(gate -> gate.middle().flatDistanceTo(here) < KEPT_M)
        .filter(gate -> nearest(gate.middle(), SAME_M).isEmpty())
        .ifPresent(gates::add);
    Optional<Point> from = before;
    before = Optional.of(here);
    Optional<Gate> now =
        gates.stream()
            .filter(gate -> !isPassed(gate))
            .filter(gate -> from.map(place -> gate.isPassed(place, here)).orElse(false))
            .findFirst();
    now.ifPresent(
        gate -> {
          passed.add(gate.middle());
          last = now;
        });
    return now.isPresent();
  }

  public int passed() {
    return passed.size();
  }

  /** The most recently passed gate. */
  public Optional<Gate> last() {
    return last;
  }

  /** Stores the gate to which the boat is sailing. */
  public void aimAt(Optional<Gate> gate) {
    aimed = gate;
  }

  private boolean isPassed(Gate gate) {
    return passed.stream().anyMatch(old -> old.flatDistanceTo(gate.middle()) < SAME_M);
  }

  /** The newest estimate of a gate that has not been passed. */
  public Optional<Gate> again(Gate gate) {
    return nearest(gate.middle(), SAME_M);
  }

  /** The gate nearest to a point among those not yet passed. */
  public Optional<Gate> nearest(Point place, double withinM) {
    return gates.stream()
        .filter(gate -> !isPassed(gate) && gate.middle().flatDistanceTo(place) < withinM)
        .min(Comparator.comparingDouble(gate -> gate.middle().flatDistanceTo(place)));
  }

  /** The gate nearest to a point that is ahead of it and beyond another gate. */
  public Optional<Gate> next(Point here, Gate behind) {
    return gates.stream()
        .filter(gate -> !isPassed(gate) && gate.aheadM(here) > -BEHIND_M)
        .filter(gate -> behind.aheadM(gate.middle()) < -SAME_M)
        .filter(gate -> gate.middle().flatDistanceTo(here) < REACH_M)
        .min(Comparator.comparingDouble(gate -> gate.middle().flatDistanceTo(here)));
  }
}
