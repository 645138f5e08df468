package org.u2sa.core.launch;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.service.ServiceRole;
import org.u2sa.service.U2SAService;

/**
 * Finds gaps in the flow from sensors to actuators: services that wait for messages of a kind that
 * no other service of the system publishes, or command where none obeys. They would be silent.
 */
final class ChannelGaps {
  private final List<U2SAService> services;
  private final List<String> sentences = new ArrayList<>();

  private ChannelGaps(List<U2SAService> services) {
    this.services = services;
  }

  /** A sentence for each gap. */
  static List<String> of(List<U2SAService> services) {
    ChannelGaps gaps = new ChannelGaps(services);
    gaps.unpublished(Channels.SENSED_STATE, List.of(ServiceRole.STATE_ESTIMATOR));
    gaps.unpublished(Channels.STATE, List.of(ServiceRole.PATH_PLANNER, ServiceRole.CONTROL_SYSTEM));
    gaps.unpublished(Channels.GOALS, List.of(ServiceRole.PATH_PLANNER));
    gaps.unpublished(Channels.NAVIGATION, List.of(ServiceRole.CONTROL_SYSTEM));
    gaps.disobeyed();
    return gaps.sentences;
  }

  private void unpublished(Channel<?> channel, List<ServiceRole> roles) {
    String waiting =
        names(each -> roles.contains(each.role()) && each.subscribedChannels().contains(channel));
    if (!waiting.isEmpty() && names(each -> each.publishedChannels().contains(channel)).isEmpty()) {
      sentences.add("no service publishes \"" + channel + "\"; needed by " + waiting);
    }
  }

  private void disobeyed() {
    Channel<?> channel = Channels.ACTUATION;
    String commanding = names(each -> each.role() == ServiceRole.CONTROL_SYSTEM);
    String obeying =
        names(
            each ->
                each.role() != ServiceRole.OBSERVER && each.subscribedChannels().contains(channel));
    if (!commanding.isEmpty() && obeying.isEmpty()) {
      sentences.add("no service drives actuators by \"" + channel + "\"; needed by " + commanding);
    }
  }

  private String names(Predicate<U2SAService> which) {
    return services.stream()
        .filter(which)
        .map(U2SAService::getServiceName)
        .collect(Collectors.joining(", "));
  }
}
