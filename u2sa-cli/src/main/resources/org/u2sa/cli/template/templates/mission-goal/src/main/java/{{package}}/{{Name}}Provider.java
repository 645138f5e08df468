package {{package}};

import java.util.Collection;
import java.util.List;
import org.u2sa.planning.PlannerState;
import org.u2sa.planning.PlannerStateProvider;
import org.u2sa.planning.PlannerView;
import org.u2sa.interfaces.configuration.Configurator;
import org.u2sa.messages.schema.MessageType;
import org.u2sa.messages.schema.MessageTypeProvider;

/**
 * Registers {@link {{Name}}} with missions, message readers and path planners; listed in META-INF/services.
 */
public final class {{Name}}Provider implements MessageTypeProvider, PlannerStateProvider {
  @Override
  public Collection<MessageType<?>> messageTypes() {
    return List.of({{Name}}.TYPE);
  }

  @Override
  public Collection<PlannerState> plannerStates(Configurator planner, PlannerView surroundings) {
    return List.of(new {{Name}}State());
  }
}
