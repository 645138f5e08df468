package org.u2sa.gcs.remote;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.u2sa.messages.schema.U2SAData;

/** What came in on a question so far. Filled by the transport's thread, read by the asking one. */
final class Answers<T extends U2SAData> {
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
