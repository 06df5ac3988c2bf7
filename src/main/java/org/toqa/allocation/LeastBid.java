package org.toqa.allocation;

import static java.util.Comparator.comparingDouble;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.toqa.allocation.SequentialAllocation.Chosen;
import org.toqa.wording.Phrase;
import org.toqa.wording.Sentence;

/**
 * The awards of a contract net (Smith, 1980; FIPA SC00029H): one task after the other goes to the
 * least bid of those robots that have none yet.
 */
final class LeastBid implements Allocator {

  /** A robot with what it said of a task. */
  private record Answer(Candidate robot, Quote quote) {}

  @Override
  public List<Decision> allocate(AllocationProblem problem) {
    Quotes quotes = problem.quotes();
    return SequentialAllocation.allocate(
        problem, (task, left) -> choose(answers(task, left, quotes)));
  }

  private static List<Answer> answers(AllocationTask task, List<Candidate> robots, Quotes quotes) {
    List<Quote> said = quotes.of(task, robots);
    return IntStream.range(0, robots.size())
        .mapToObj(i -> new Answer(robots.get(i), said.get(i)))
        .toList();
  }

  private static Optional<Chosen> choose(List<Answer> answers) {
    List<Answer> bids =
        answers.stream()
            .filter(answer -> answer.quote().isPossible())
            .sorted(
                comparingDouble((Answer answer) -> answer.quote().joules())
                    .thenComparing(answer -> answer.robot().robot()))
            .toList();
    return bids.isEmpty()
        ? Optional.empty()
        : Optional.of(new Chosen(bids.getFirst().robot(), reason(bids, answers)));
  }

  private static Sentence reason(List<Answer> bids, List<Answer> answers) {
    Sentence least =
        bids.size() == 1
            ? Phrase.ONLY_BID.with(kilojoules(bids.getFirst()))
            : Phrase.LEAST_BID.with(
                bids.size(),
                kilojoules(bids.getFirst()),
                bids.get(1).robot().robot(),
                kilojoules(bids.get(1)));
    Map<Boolean, List<String>> others =
        answers.stream()
            .filter(answer -> !answer.quote().isPossible())
            .collect(
                Collectors.partitioningBy(
                    answer -> answer.quote().impediment() == Impediment.SILENT,
                    Collectors.mapping(answer -> answer.robot().robot(), Collectors.toList())));
    return Stream.of(least)
        .map(said -> with(Phrase.DECLINED_BY, said, others.getOrDefault(false, List.of())))
        .map(said -> with(Phrase.NO_ANSWER_FROM, said, others.getOrDefault(true, List.of())))
        .findFirst()
        .orElseThrow();
  }

  private static Sentence with(Phrase phrase, Sentence said, List<String> robots) {
    return robots.isEmpty() ? said : phrase.with(said, Sentence.names(robots));
  }

  private static double kilojoules(Answer bid) {
    return bid.quote().joules() / 1000;
  }
}
