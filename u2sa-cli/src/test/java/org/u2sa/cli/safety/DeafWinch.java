package org.u2sa.cli.safety;

import java.util.List;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.service.EventDrivenService;
import org.u2sa.service.ServiceContext;
import org.u2sa.service.ServiceRole;

/** Says that it heeds emergency stops, and hears none: its cable is cut, for example. */
public final class DeafWinch extends EventDrivenService {
  /** Called by the launcher. */
  public DeafWinch(ServiceContext context) {
    super(context, ServiceRole.ACTUATOR, "Winch");
    heedsEmergencyStops(List.of());
  }

  @Override
  public void callback(U2SAData data) {
    unexpected(data);
  }
}
