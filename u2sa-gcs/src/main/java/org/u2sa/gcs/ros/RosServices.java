package org.u2sa.gcs.ros;

import static org.u2sa.gcs.ros.RosSpelling.fields;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Predicate;
import org.u2sa.gcs.remote.RemoteLink;
import org.u2sa.gcs.services.DirectoryObservation;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.contract.ConfigurationTransaction;
import org.u2sa.service.directory.DataOffer;
import org.u2sa.service.directory.KnownService;

/**
 * Services that clients may call: rosapi, which ROS tools use to list topics, services, nodes and
 * parameters. Calls may take seconds.
 */
final class RosServices {
  private static final long NANOS_PER_MICRO = 1_000L;
  private static final String NAMESPACE = "/rosapi/";
  private static final String TOPICS = "topics";
  private static final String TYPES = "types";
  private static final String SERVICES = "services";
  private static final String TYPE = "type";
  private static final String NAME = "name";

  /** A call; its arguments are not checked yet. */
  private record Call(Map<?, ?> arguments, RosAccount account) {
    String text(String name) {
      if (arguments.get(name) instanceof String text) {
        return text;
      }
      throw new BadInputException("argument \"" + name + "\": expected a text");
    }

    RosParameters parameters() {
      return new RosParameters(account.link());
    }
  }

  private interface Service {
    Map<String, Object> answer(Call call) throws InterruptedException;
  }

  private record Entry(String type, Service service) {}

  private final List<RosTopic> topics;
  private final RosTypes types = new RosTypes();
  private final Map<String, Entry> services = new LinkedHashMap<>();

  RosServices(List<RosTopic> topics) {
    this.topics = topics;
    addTopics();
    addServices();
    addNodes();
    addParameters();
  }

  private void add(String name, String type, Service service) {
    services.put(NAMESPACE + name, new Entry("rosapi_msgs/srv/" + type, service));
  }

  private void addTopics() {
    add(TOPICS, "Topics", call -> fields(TOPICS, names(any -> true), TYPES, typesOfTopics()));
    add(
        "topics_and_raw_types",
        "TopicsAndRawTypes",
        call ->
            fields(
                TOPICS,
                names(any -> true),
                TYPES,
                typesOfTopics(),
                "typedefs_full_text",
                topics.stream().map(topic -> (Object) types.text(topic.type())).toList()));
    add(
        "topic_type",
        "TopicType",
        call -> fields(TYPE, topic(call.text("topic")).map(RosTopic::type).orElse("")));
    add(
        "topics_for_type",
        "TopicsForType",
        call -> {
          String wanted = RosSpelling.ros2(call.text(TYPE));
          return fields(TOPICS, names(topic -> topic.type().equals(wanted)));
        });
    add(
        "message_details",
        "MessageDetails",
        call ->
            fields(
                "typedefs",
                types
                    .details(call.text(TYPE))
                    .orElseThrow(
                        () ->
                            new BadInputException(
                                "type \"" + call.text(TYPE) + "\" has no definition here"))));
    add(
        "get_time",
        "GetTime",
        call -> {
          long nanos = call.account().link().clock().micros() * NANOS_PER_MICRO;
          RosSpelling.Time now = new RosSpelling.Time(nanos);
          return fields("time", now);
        });
    add("get_ros_version", "GetROSVersion", call -> fields("version", 2, "distro", "u2sa"));
  }

  private List<Object> names(Predicate<RosTopic> wanted) {
    return topics.stream().filter(wanted).map(topic -> (Object) topic.name()).toList();
  }

  private List<Object> typesOfTopics() {
    return topics.stream().map(topic -> (Object) topic.type()).toList();
  }

  private Optional<RosTopic> topic(String name) {
    String rooted = name.startsWith("/") ? name : "/" + name;
    return topics.stream().filter(topic -> topic.name().equals(rooted)).findFirst();
  }

  private void addServices() {
    add(SERVICES, "Services", call -> fields(SERVICES, new ArrayList<>(services.keySet())));
    add(
        "service_type",
        "ServiceType",
        call -> {
          Entry entry = services.get(call.text("service"));
          return fields(TYPE, entry == null ? "" : entry.type());
        });
    add(
        "services_for_type",
        "ServicesForType",
        call -> {
          String last = "/" + call.text(TYPE).replaceFirst(".*/", "");
          List<Object> found = new ArrayList<>();
          services.forEach(
              (name, entry) -> {
                if (entry.type().endsWith(last)) {
                  found.add(name);
                }
              });
          return fields(SERVICES, found);
        });
    add("service_request_details", "ServiceRequestDetails", call -> fields("typedefs", List.of()));
    add(
        "service_response_details",
        "ServiceResponseDetails",
        call -> fields("typedefs", List.of()));
    add("action_servers", "GetActionServers", call -> fields("action_servers", List.of()));
  }

  private void addNodes() {
    add(
        "nodes",
        "Nodes",
        call -> {
          List<Object> names = new ArrayList<>();
          nodes(call.account().link()).forEach(node -> names.add("/" + node.name()));
          return fields("nodes", names);
        });
    add(
        "node_details",
        "NodeDetails",
        call -> {
          String wanted = call.text("node").replaceFirst("^/", "");
          KnownService node =
              nodes(call.account().link()).stream()
                  .filter(each -> each.name().equals(wanted))
                  .findFirst()
                  .orElseThrow(
                      () -> new BadInputException("node \"" + wanted + "\" did not answer"));
          return fields(
              "subscribing",
              topicsOf(node.subscribes()),
              "publishing",
              topicsOf(node.publishes()),
              SERVICES,
              List.of());
        });
  }

  private static List<KnownService> nodes(RemoteLink link) throws InterruptedException {
    return DirectoryObservation.made(link).directory().services();
  }

  private static List<Object> topicsOf(List<DataOffer> offers) {
    return offers.stream()
        .map(offer -> (Object) (RosTopic.NATIVE + offer.channel().replace('-', '_')))
        .distinct()
        .toList();
  }

  private void addParameters() {
    add("get_param_names", "GetParamNames", call -> fields("names", call.parameters().names()));
    add("get_param", "GetParam", call -> fields("value", call.parameters().value(call.text(NAME))));
    add(
        "has_param",
        "HasParam",
        call -> fields("exists", call.parameters().find(call.text(NAME)).isPresent()));
    add(
        "set_param",
        "SetParam",
        call -> {
          call.account().requireRight(Channels.CONFIGURATION, ConfigurationTransaction.TYPE);
          call.parameters().set(call.text(NAME), call.text("value"));
          return fields();
        });
    add(
        "delete_param",
        "DeleteParam",
        call -> {
          throw new BadInputException(
              "parameter \"" + call.text(NAME) + "\" belongs to its service and cannot be deleted");
        });
  }

  /**
   * Calls a service.
   *
   * @return its answer's fields
   * @throws RuntimeException if the service is unknown or refuses; the message is for the caller
   */
  Map<String, Object> call(String name, Map<?, ?> arguments, RosAccount account)
      throws InterruptedException {
    Entry entry = services.get(name.startsWith("/") ? name : "/" + name);
    if (entry == null) {
      throw new BadInputException(
          "service \"" + name + "\" does not exist; /rosapi/services lists all");
    }
    return entry.service().answer(new Call(arguments, account));
  }
}
