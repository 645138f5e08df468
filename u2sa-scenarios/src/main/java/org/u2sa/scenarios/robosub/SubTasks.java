package org.u2sa.scenarios.robosub;

import java.util.Collection;
import java.util.List;
import org.u2sa.interfaces.configuration.Configurator;
import org.u2sa.messages.schema.MessageType;
import org.u2sa.messages.schema.MessageTypeProvider;
import org.u2sa.planning.PlannerState;
import org.u2sa.planning.PlannerStateProvider;
import org.u2sa.planning.PlannerView;

/** Registers RoboSub's goal classes and their planner states. */
public final class SubTasks implements MessageTypeProvider, PlannerStateProvider {
  @Override
  public Collection<MessageType<?>> messageTypes() {
    return List.of(
        SubTask.TYPE,
        PassGate.TYPE,
        BumpBuoy.TYPE,
        SurfaceInRing.TYPE,
        FollowMarker.TYPE,
        DropMarkers.TYPE,
        ShootTorpedoes.TYPE,
        HomeOnPinger.TYPE);
  }

  @Override
  public Collection<PlannerState> plannerStates(
      Configurator configuration, PlannerView surroundings) {
    TaskSight sight = new TaskSight(surroundings);
    return List.of(
        new GateState(sight),
        new BuoyState(sight),
        new RingState(sight),
        new MarkerState(sight),
        new BinState(sight),
        new TorpedoState(sight),
        new PingerState(sight));
  }
}
