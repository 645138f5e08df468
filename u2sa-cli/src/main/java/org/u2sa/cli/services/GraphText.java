package org.u2sa.cli.services;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.u2sa.cli.terminal.TextTable;
import org.u2sa.gcs.services.ServiceGraph;
import org.u2sa.gcs.services.ServiceGraph.Feed;
import org.u2sa.interfaces.JsonText;

/**
 * Formats a {@link ServiceGraph} as text, for drawing programs (Mermaid, Graphviz), and as JSON.
 */
final class GraphText {
  private GraphText() {}

  /** One line per feed, by publisher; then loose ends and services that have not answered. */
  static List<String> lines(ServiceGraph graph) {
    List<String> lines = new ArrayList<>();
    TextTable feeds = new TextTable("FROM", "TO", "CHANNEL", "TYPE");
    graph
        .feeds()
        .forEach(feed -> feeds.add(feed.from(), "-> " + feed.to(), feed.channel(), feed.type()));
    lines.addAll(feeds.lines());
    String known = graph.unanswered().isEmpty() ? "" : " that has answered";
    looseEnds(lines, "Published without subscribers" + known + ":", graph.unheard());
    looseEnds(lines, "Subscribed to without publishers" + known + ":", graph.unfed());
    if (!graph.unanswered().isEmpty()) {
      lines.add("");
      lines.add("Discovered, but without an answer: " + String.join(", ", graph.unanswered()));
    }
    return lines;
  }

  private static void looseEnds(List<String> lines, String title, List<Feed> ends) {
    if (ends.isEmpty()) {
      return;
    }
    lines.add("");
    lines.add(title);
    TextTable table = new TextTable("NAME", "CHANNEL", "TYPE");
    ends.forEach(end -> table.add(end.from() + end.to(), end.channel(), end.type()));
    table.lines().stream().skip(1).forEach(line -> lines.add("  " + line));
  }

  /** The graph as JSON on one line; loose ends omit the key {@code from} or {@code to}. */
  static String json(String systemId, ServiceGraph graph) {
    JsonText roles = new JsonText();
    graph.services().forEach(name -> roles.put(name, graph.roles().get(name)));
    return new JsonText()
        .put("system", systemId)
        .put("services", roles)
        .put("feeds", json(graph.feeds()))
        .put("unheard", json(graph.unheard()))
        .put("unfed", json(graph.unfed()))
        .put("unanswered", graph.unanswered())
        .line();
  }

  private static List<JsonText> json(List<Feed> feeds) {
    return feeds.stream()
        .map(
            feed ->
                new JsonText()
                    .put("from", Optional.of(feed.from()).filter(name -> !name.isEmpty()))
                    .put("to", Optional.of(feed.to()).filter(name -> !name.isEmpty()))
                    .put("channel", feed.channel())
                    .put("type", feed.type()))
        .toList();
  }

  /** The graph in Mermaid syntax; loose ends are dashed. */
  static List<String> mermaid(ServiceGraph graph) {
    List<String> lines = new ArrayList<>();
    lines.add("flowchart LR");
    List<String> services = graph.services();
    for (int i = 0; i < services.size(); i++) {
      String role = graph.roles().get(services.get(i));
      String label = escaped(services.get(i)) + (role.isEmpty() ? "" : "<br/>" + escaped(role));
      lines.add("  s" + i + "[\"" + label + "\"]");
    }
    for (Feed arrow : arrows(graph)) {
      Optional<String> point = point(graph, arrow);
      point.ifPresent(name -> lines.add("  " + name + "(( ))"));
      String line = point.isPresent() ? " -.->" : " -->";
      String label = escaped(arrow.channel()) + "<br/>" + escaped(arrow.type());
      lines.add(
          String.format(
              "  %s%s|\"%s\"| %s",
              box(services, arrow.from()), line, label, box(services, arrow.to())));
    }
    return lines;
  }

  private static String box(List<String> services, String name) {
    int index = services.indexOf(name);
    return index < 0 ? name : "s" + index;
  }

  /** Escapes Mermaid's special characters as entities. */
  private static String escaped(String text) {
    return text.replace("#", "#35;").replace("\"", "#quot;").replace("<", "#lt;");
  }

  /** The graph in Graphviz syntax; loose ends are dashed. */
  static List<String> dot(String systemId, ServiceGraph graph) {
    List<String> lines = new ArrayList<>();
    lines.add("digraph " + quoted(systemId) + " {");
    lines.add("  rankdir=LR;");
    lines.add("  node [shape=box, fontname=\"Helvetica\"];");
    lines.add("  edge [fontname=\"Helvetica\", fontsize=10];");
    for (String service : graph.services()) {
      String role = graph.roles().get(service);
      String label = quoted(role.isEmpty() ? service : service + "\\n" + role);
      lines.add("  " + quoted(service) + " [label=" + label + "];");
    }
    for (Feed arrow : arrows(graph)) {
      Optional<String> point = point(graph, arrow);
      point.ifPresent(name -> lines.add("  " + name + " [shape=point];"));
      lines.add(
          String.format(
              "  %s -> %s [label=%s, style=%s];",
              quoted(arrow.from()),
              quoted(arrow.to()),
              quoted(arrow.channel() + "\\n" + arrow.type()),
              point.isPresent() ? "dashed" : "solid"));
    }
    lines.add("}");
    return lines;
  }

  /** All feeds; a loose end starts or ends at its own point. */
  private static List<Feed> arrows(ServiceGraph graph) {
    List<Feed> arrows = new ArrayList<>(graph.feeds());
    int number = 0;
    for (Feed end : graph.unheard()) {
      arrows.add(new Feed(end.from(), "nobody" + number++, end.channel(), end.type()));
    }
    for (Feed end : graph.unfed()) {
      arrows.add(new Feed("nobody" + number++, end.to(), end.channel(), end.type()));
    }
    return arrows;
  }

  /** End of an arrow without a service. */
  private static Optional<String> point(ServiceGraph graph, Feed arrow) {
    return Stream.of(arrow.from(), arrow.to())
        .filter(name -> !graph.services().contains(name))
        .findFirst();
  }

  /** Escapes backslashes and quotes, but keeps {@code \n} as a line break. */
  private static String quoted(String text) {
    return "\"" + text.replaceAll("\\\\(?!n)", "\\\\\\\\").replace("\"", "\\\"") + "\"";
  }
}
