package org.u2sa.scenarios.vrx;

import java.nio.file.Path;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.goal.GoalInformation;
import org.u2sa.sim.vehicle.VehicleTruth;
import org.u2sa.sim.world.Footprint;

/**
 * Scan and dock. Points are given for the sequence of the light buoy (first submission only), for
 * staying in a bay and leaving it by its entrance, and for the right bay; higher is better. Ball
 * throwing is omitted (ScanDockScoringPlugin.cc).
 */
final class DockJudge extends VrxJudge {
  private final Docking docking;
  private final Collisions collisions;
  private final double[] insideSinceS;
  private final boolean[] docked;
  private boolean submitted;
  private double sequencePoints;
  private double dockPoints;
  private double rightBayPoints;
  private double lastS;

  DockJudge(VrxWorld world, Footprint outline, Path directory) {
    super(world, directory);
    docking = world.docking();
    collisions = new Collisions(world, outline);
    insideSinceS = new double[docking.bays().size()];
    docked = new boolean[insideSinceS.length];
    Arrays.fill(insideSinceS, Double.NaN);
  }

  @Override
  public List<Channel<?>> listensTo() {
    return List.of(Channels.GOAL_UPDATES);
  }

  /** {@inheritDoc} The boat submits the sequence as a field of its goal. */
  @Override
  public void reported(GoalInformation report) {
    if (report instanceof DockBySign goal && !goal.sequence().isEmpty() && !submitted) {
      submitted = true;
      boolean isRight = goal.sequence().equals(docking.sequence());
      sequencePoints = isRight ? docking.points().sequence() : 0.0;
      say(lastS, "sequence " + goal.sequence() + (isRight ? "" : " is wrong"));
    }
  }

  @Override
  void score(VehicleTruth truth, double sinceS) {
    lastS = sinceS;
    collisions.see(truth, sinceS, this);
    for (int i = 0; i < docked.length; i++) {
      boolean isInside = docking.isInside(i, truth.position());
      if (isInside && Double.isNaN(insideSinceS[i])) {
        insideSinceS[i] = sinceS;
        say(sinceS, "enters bay " + (i + 1));
      } else if (!isInside) {
        insideSinceS[i] = Double.NaN;
      } else if (!docked[i] && sinceS - insideSinceS[i] >= docking.stayS()) {
        docked[i] = true;
        say(sinceS, "has docked in bay " + (i + 1));
      }
      if (docked[i] && docking.isBefore(i, truth.position())) {
        dockPoints = docking.points().dock();
        rightBayPoints = docking.bays().get(i).isRight() ? docking.points().rightBay() : 0.0;
        say(sinceS, "has left bay " + (i + 1));
        finish();
        return;
      }
    }
  }

  @Override
  double score() {
    return sequencePoints + dockPoints + rightBayPoints;
  }

  @Override
  int contacts() {
    return collisions.count();
  }

  @Override
  Map<String, Double> figures() {
    Map<String, Double> figures = new LinkedHashMap<>();
    figures.put("sequencePoints", sequencePoints);
    figures.put("dockPoints", dockPoints);
    figures.put("rightBayPoints", rightBayPoints);
    return figures;
  }
}
