package org.u2sa.scenarios.simulate;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.mission.MissionAction;
import org.u2sa.messages.mission.MissionOrder;
import org.u2sa.messages.safety.FenceAction;
import org.u2sa.messages.safety.FenceOrder;
import org.u2sa.service.PeriodicService;
import org.u2sa.service.ServiceContext;
import org.u2sa.service.ServiceRole;

/**
 * Gives one mission order and one fence order, each if its file exists, at a time after the start.
 * In: nothing. Out: mission, fence-orders.
 */
public final class ScriptedOperator extends PeriodicService {
  private final Path folder;
  private final double atS;
  private final MissionAction action;
  private double beganS = Double.NaN;
  private boolean given;

  public ScriptedOperator(ServiceContext context) {
    super(context, ServiceRole.OBSERVER, "ScriptedOperator", 10.0);
    folder = Path.of((String) getVariable("FOLDER"));
    atS = (Double) getVariable("AT");
    action = MissionAction.valueOf((String) getVariable("ACTION"));
    registerPublisher(Channels.MISSION);
    registerPublisher(Channels.FENCE_ORDERS);
  }

  @Override
  protected void step(double nowS) {
    beganS = Double.isNaN(beganS) ? nowS : beganS;
    if (given || nowS - beganS < atS) {
      return;
    }
    given = true;
    Path mission = folder.resolve("ordered-mission.xml");
    Path fence = folder.resolve("ordered-fence.xml");
    if (Files.exists(mission)) {
      publish(
          Channels.MISSION,
          new MissionOrder()
              .requestId("mission")
              .action(action)
              .operator("ann")
              .goals(text(mission))
              .now(true));
    }
    if (Files.exists(fence)) {
      publish(
          Channels.FENCE_ORDERS,
          new FenceOrder()
              .requestId("fence")
              .action(FenceAction.REPLACE)
              .operator("ann")
              .fence(text(fence)));
    }
  }

  private static String text(Path file) {
    try {
      return Files.readString(file);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }
}
