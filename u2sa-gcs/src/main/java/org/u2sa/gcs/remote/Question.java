package org.u2sa.gcs.remote;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Set;
import java.util.function.Function;
import java.util.function.Predicate;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.messages.schema.U2SAData;

/**
 * A request to the services of a running system, and which of the messages that follow on its
 * channel answer it. Asked once, by {@link RemoteLink#ask}.
 *
 * <pre>{@code
 * link.ask(
 *     new Question<>(Channels.CONFIGURATION, request, ConfigurationResponse.class)
 *         .oneOfEach(ConfigurationResponse::serviceName)
 *         .expecting(Set.of("PathPlanner")));
 * }</pre>
 *
 * @param <T> the class of the answers
 */
public final class Question<T extends U2SAData> {
  private final Channel<?> channel;
  private final U2SAData request;
  private final Class<T> answerClass;
  private Predicate<? super T> counts = answer -> true;
  private Function<? super T, String> source; // null: each answer is one of its own
  private Predicate<Answers<T>> enough = answers -> false;

  /**
   * A question to which every message of the class is an answer, for as long as the link's time
   * lasts.
   *
   * @param channel where the request is published and answers come in
   * @param request not frozen yet; the link fills in system and time
   * @param answerClass what answers are; subclasses count
   */
  public Question(Channel<?> channel, U2SAData request, Class<T> answerClass) {
    this.channel = Objects.requireNonNull(channel, "channel");
    this.request = Objects.requireNonNull(request, "request");
    this.answerClass = Objects.requireNonNull(answerClass, "answerClass");
  }

  /** Only these are answers, for example those with the request's ID. */
  public Question<T> only(Predicate<? super T> wanted) {
    counts = wanted;
    return this;
  }

  /**
   * Of several answers of one source the newest is kept, in the place of the first.
   *
   * @param name tells the sources apart, for example the service's name
   */
  public Question<T> oneOfEach(Function<? super T, String> name) {
    source = name;
    return this;
  }

  /** Waits no longer once each of these sources has answered; see {@link #oneOfEach}. */
  public Question<T> expecting(Set<String> sources) {
    enough = got -> got.sources().containsAll(sources);
    return this;
  }

  /**
   * Waits no longer once every service that was heard has answered, or all of these; see {@link
   * #oneOfEach}. An empty set stands for nobody in particular.
   */
  public Question<T> expectingAll(HeardServices heard, Set<String> orThese) {
    enough =
        got ->
            !orThese.isEmpty() && got.sources().containsAll(orThese)
                || heard.areAmong(got.sources());
    return this;
  }

  /** Waits for one answer only. */
  public Question<T> first() {
    enough = got -> !got.list().isEmpty();
    return this;
  }

  Channel<?> channel() {
    return channel;
  }

  U2SAData request() {
    return request;
  }

  /** A place for answers, empty. */
  Answers<T> answers() {
    return new Answers<>(this);
  }

  /** The message as an answer to this, or null. */
  T answer(U2SAData message) {
    if (!answerClass.isInstance(message)) {
      return null;
    }
    T answer = answerClass.cast(message);
    return counts.test(answer) ? answer : null;
  }

  /** Who answered; of answers that each count the number so far. */
  String sourceOf(T answer, int answersSoFar) {
    return source == null ? String.valueOf(answersSoFar) : source.apply(answer);
  }

  boolean isEnough(Answers<T> answers) {
    return enough.test(answers);
  }

  /**
   * What came in on a question so far. Filled by the transport's thread, read by the asking one.
   */
  static final class Answers<T extends U2SAData> {
    private final Question<T> question;
    private final Map<String, T> bySource = new LinkedHashMap<>();

    Answers(Question<T> question) {
      this.question = question;
    }

    /** Takes a message; returns whether it is an answer. */
    synchronized boolean take(U2SAData message) {
      T answer = question.answer(message);
      if (answer == null) {
        return false;
      }
      bySource.put(question.sourceOf(answer, bySource.size()), answer);
      return true;
    }

    synchronized boolean areEnough() {
      return question.isEnough(this);
    }

    synchronized List<T> list() {
      return new ArrayList<>(bySource.values());
    }

    synchronized Set<String> sources() {
      return Set.copyOf(bySource.keySet());
    }
  }
}
