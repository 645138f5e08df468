package org.u2sa.gcs.services;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Predicate;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.contract.DiscoveryResponse;
import org.u2sa.service.ServiceRole;
import org.u2sa.service.directory.DataOffer;
import org.u2sa.service.directory.KnownService;

/**
 * Data flow graph of services. Channels of the service contract, which connect every service with
 * every other, are omitted.
 *
 * @param services names, in layers from sensors to actuators
 * @param roles role of each, in words; empty if unknown
 * @param feeds all pairs of publisher and subscriber, in the order of the services
 * @param unheard publications without subscribers
 * @param unfed subscriptions without publishers
 * @param unanswered services whose publications and subscriptions are unknown; they may explain
 *     loose ends
 */
public record ServiceGraph(
    List<String> services,
    Map<String, String> roles,
    List<Feed> feeds,
    List<Feed> unheard,
    List<Feed> unfed,
    List<String> unanswered) {
  private static final Set<String> OF_EVERYBODY =
      Set.of(
          Channels.DISCOVERY.name(),
          Channels.FUNCTIONALITY.name(),
          Channels.STOP.name(),
          Channels.CONFIGURATION.name(),
          Channels.HEALTH.name());

  public static ServiceGraph of(List<KnownService> known) {
    List<KnownService> ordered = new ArrayList<>(known);
    ordered.sort(Comparator.comparingInt(ServiceGraph::layer).thenComparing(KnownService::name));
    List<Feed> feeds = new ArrayList<>();
    List<Feed> unheard = new ArrayList<>();
    List<Feed> unfed = new ArrayList<>();
    for (KnownService one : ordered) {
      for (DataOffer offer : ofInterest(one.publishes())) {
        if (!feed(one, offer, ordered, feeds)) {
          unheard.add(new Feed(one.name(), "", offer.channel(), offer.typeName()));
        }
      }
      for (DataOffer wanted : ofInterest(one.subscribes())) {
        if (nobody(ordered, one, other -> feeds(other, wanted))) {
          unfed.add(new Feed("", one.name(), wanted.channel(), wanted.typeName()));
        }
      }
    }
    Map<String, String> roles = new LinkedHashMap<>();
    ordered.forEach(service -> roles.put(service.name(), role(service)));
    return new ServiceGraph(
        ordered.stream().map(KnownService::name).toList(),
        roles,
        feeds,
        unheard,
        unfed,
        ordered.stream().filter(each -> !each.isComplete()).map(KnownService::name).toList());
  }

  private static String role(KnownService service) {
    return service.isComplete() ? ServiceRow.of(service, null).type() : "no answer";
  }

  /** Roles are declared in data flow order. */
  private static int layer(KnownService service) {
    String type = service.discovery().map(DiscoveryResponse::serviceType).orElse("");
    for (ServiceRole role : ServiceRole.values()) {
      if (role.name().equals(type)) {
        return role.ordinal();
      }
    }
    return ServiceRole.values().length;
  }

  private static List<DataOffer> ofInterest(List<DataOffer> offers) {
    return offers.stream().filter(offer -> !OF_EVERYBODY.contains(offer.channel())).toList();
  }

  /** Adds the feeds of an offer; returns whether it has other subscribers. */
  private static boolean feed(
      KnownService from, DataOffer offer, List<KnownService> services, List<Feed> feeds) {
    boolean heard = false;
    for (KnownService to : services) {
      Optional<DataOffer> wanted =
          to.subscribes().stream().filter(each -> fits(offer, each)).findFirst();
      if (wanted.isPresent() && !to.name().equals(from.name())) {
        feeds.add(new Feed(from.name(), to.name(), offer.channel(), narrower(offer, wanted.get())));
        heard = true;
      }
    }
    return heard;
  }

  private static boolean nobody(
      List<KnownService> services, KnownService but, Predicate<KnownService> is) {
    return services.stream().noneMatch(each -> !each.name().equals(but.name()) && is.test(each));
  }

  private static boolean feeds(KnownService other, DataOffer wanted) {
    return other.publishes().stream().anyMatch(offer -> fits(offer, wanted));
  }

  private static boolean fits(DataOffer offer, DataOffer wanted) {
    return offer.channel().equals(wanted.channel())
        && (offer.typeChain().isEmpty()
            || wanted.typeChain().isEmpty()
            || offer.mayBe(wanted.typeChain()));
  }

  private static String narrower(DataOffer one, DataOffer other) {
    return one.typeChain().size() >= other.typeChain().size() ? one.typeName() : other.typeName();
  }

  /**
   * Data flow from one service to another; a loose end has only one service.
   *
   * @param from publisher; empty if none
   * @param to subscriber; empty if none
   * @param channel the channel's name
   * @param type the narrower of their two types
   */
  public record Feed(String from, String to, String channel, String type) {}
}
