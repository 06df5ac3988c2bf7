package org.toqa.allocation;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.toqa.allocation.Trade.Leg;

/**
 * Clears a market of robots that have a task each, or none (TraderBots: Dias, 2004): each has said
 * what every offered task would cost it, its own included. Of all ways to change hands the one that
 * saves most is found, an {@link Assignment}; it falls apart into sales, chains and rings, and each
 * of them is a trade of its own that saves something. What it saves is shared evenly among those
 * who take part: that makes the prices.
 */
final class Market {
  /** Joules: what half a metre costs. A trade that saves less is none. */
  static final double LEAST_SAVING = Energy.joules(0.5, 0);

  /** Above any sum of real costs. */
  private static final double FORBIDDEN = 1e12;

  private final List<Long> tasks;
  private final Map<Long, String> holders;
  private final List<String> traders;
  private final ReceivedQuotes quotes;

  /**
   * @param holders by task that is offered, who has it; each one once, and has quoted it
   * @param traders those, and robots without a task
   */
  Market(Map<Long, String> holders, List<String> traders, ReceivedQuotes quotes) {
    this.holders = Map.copyOf(holders);
    this.tasks = holders.keySet().stream().sorted().toList();
    this.traders = List.copyOf(traders);
    this.quotes = quotes;
  }

  List<Trade> clear() {
    Map<String, Leg> sales = sales();
    Set<String> buyers = new HashSet<>();
    sales.values().forEach(sale -> buyers.add(sale.buyer()));
    Set<String> done = new HashSet<>();
    List<Trade> trades = new ArrayList<>();
    for (String seller : sales.keySet()) { // chains
      if (!buyers.contains(seller)) {
        add(trades, legsFrom(seller, sales, done), false);
      }
    }
    for (String seller : sales.keySet()) { // what is left goes round
      if (!done.contains(seller)) {
        add(trades, legsFrom(seller, sales, done), true);
      }
    }
    return trades;
  }

  /** By seller, in the order of the tasks; without prices. */
  private Map<String, Leg> sales() {
    double[] costs = new double[tasks.size() * traders.size()];
    for (int task = 0; task < tasks.size(); task++) {
      for (int robot = 0; robot < traders.size(); robot++) {
        costs[task * traders.size() + robot] = joules(tasks.get(task), traders.get(robot));
      }
    }
    int[] robotOf = Assignment.leastCost(costs, tasks.size());
    Map<String, Leg> sales = new LinkedHashMap<>();
    for (int task = 0; task < tasks.size(); task++) {
      String holder = holder(tasks.get(task));
      String buyer = traders.get(robotOf[task]);
      if (!holder.equals(buyer)) {
        sales.put(holder, new Leg(tasks.get(task), holder, buyer, 0));
      }
    }
    return sales;
  }

  private String holder(long task) {
    return holders.getOrDefault(task, "");
  }

  private double joules(long task, String robot) {
    Quote quote = quotes.of(task, robot);
    return quote.isPossible() ? quote.joules() : FORBIDDEN;
  }

  private static List<Leg> legsFrom(String first, Map<String, Leg> sales, Set<String> done) {
    List<Leg> legs = new ArrayList<>();
    Leg next = sales.get(first);
    while (next != null && done.add(next.seller())) {
      legs.add(next);
      next = sales.get(next.buyer());
    }
    return legs;
  }

  private void add(List<Trade> trades, List<Leg> legs, boolean isRing) {
    double saved = legs.stream().mapToDouble(this::saving).sum();
    if (saved >= LEAST_SAVING) {
      trades.add(new Trade(priced(legs, saved, isRing), saved));
    }
  }

  private double saving(Leg leg) {
    return joules(leg.task(), leg.seller()) - joules(leg.task(), leg.buyer());
  }

  /**
   * Prices by which everybody gains the same. Whoever has task i, sells it at p(i) and gets the one
   * before it gains {@code c(i) - c(i-1) + p(i-1) - p(i)}, where c is what a task costs him. In a
   * ring prices may all be raised alike: the first buyer is paid its cost and its share.
   */
  private List<Leg> priced(List<Leg> legs, double saved, boolean isRing) {
    double share = saved / (isRing ? legs.size() : legs.size() + 1);
    Map<String, Double> bought = new HashMap<>();
    List<Leg> priced = new ArrayList<>();
    double before = 0;
    for (Leg leg : legs) {
      double own = joules(leg.task(), leg.seller());
      double price =
          priced.isEmpty() && isRing
              ? joules(leg.task(), leg.buyer()) + share
              : own - bought.getOrDefault(leg.seller(), 0.0) + before - share;
      priced.add(new Leg(leg.task(), leg.seller(), leg.buyer(), price));
      bought.put(leg.buyer(), joules(leg.task(), leg.buyer()));
      before = price;
    }
    return priced;
  }
}
