package org.toqa.store;

import java.time.Instant;
import java.util.Arrays;
import org.jspecify.annotations.Nullable;
import org.toqa.fleet.TaskTemplate;
import tools.jackson.databind.json.JsonMapper;

/** A row of the table of templates of tasks. */
record TaskTemplateRow(
    long id,
    String name,
    String floor,
    String taskOrder,
    String parameters,
    boolean shared,
    String userName,
    @Nullable Long userId,
    Instant changedAt) {
  private static final JsonMapper MAPPER = JsonMapper.builder().build();

  TaskTemplate toTemplate() {
    return new TaskTemplate(
        id,
        name,
        floor,
        taskOrder,
        Arrays.asList(MAPPER.readValue(parameters, TaskTemplate.Parameter[].class)),
        shared,
        userName,
        userId,
        changedAt);
  }
}
