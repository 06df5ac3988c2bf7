#!/usr/bin/env python3
"""A robot that knows of Toqa nothing but docs/robot-link.md: it drives exactly what it is told.

usage: robot.py NAME X Y      listens on a free port of loopback and prints it on standard error
"""

import json
import math
import socket
import sys
import threading
import time

TICK = 0.02


class Robot:
    def __init__(self, name, x, y):
        self.name = name
        self.pose = {"x": x, "y": y, "theta": 0.0}
        self.lock = threading.Lock()
        self.last_seq = 0
        self.task = None
        self.phase = 0
        self.drive = 0
        self.segments = []
        self.segment = 0
        self.elapsed = 0.0
        self.released = 0
        self.final = False
        self.held = False
        self.done = None
        self.twist = {"v": 0.0, "w": 0.0}
        self.server = None

    def mode(self):
        if self.held:
            return "HOLDING"
        return "DRIVING" if self.drive else "IDLE"

    def common(self):
        return {
            "localised": True, "pose": self.pose, "mode": self.mode(), "task": self.task,
            "phase": self.phase, "role": "ALONE", "drive": self.drive, "segment": self.segment,
            "released": self.released,
        }

    def hello(self):
        return {
            "type": "hello", "version": 1, "robot": self.name, "maxLoad": 5.0, "maxSpeed": 0.5, "maxTurnRate": 3.5,
            "footprint": 0.25, **self.common(), "lastSeq": self.last_seq, "done": self.done,
        }

    def state(self):
        return {
            "type": "state", "stamp": int(time.time() * 1000), **self.common(),
            "twist": self.twist, "battery": 0.9, "ranges": [], "obstacles": [], "errors": [],
        }

    # --- what the server says ---------------------------------------------------------------

    def hear(self, message):
        """Returns the answer, or None."""
        kind = message["type"]
        if kind == "ack":
            if self.done and self.done["drive"] == message["done"]:
                self.acknowledged()
            return None
        seq = message["seq"]
        if kind == "ping":
            return {"type": "ack", "seq": seq}
        if seq <= self.last_seq:
            return {"type": "ack", "seq": seq}
        reason = self.obey(kind, message)
        if reason:
            return {"type": "reject", "seq": seq, "reason": reason}
        self.last_seq = seq
        return {"type": "ack", "seq": seq}

    def acknowledged(self):
        if self.done["phase"] == 3:
            self.task, self.phase = None, 0
        self.done = None

    def obey(self, kind, message):
        if kind == "drive":
            if self.drive:
                return "It drives."
            self.done = None
            self.task, self.phase = message["task"], message["phase"]
            self.drive = message["seq"]
            self.segments = message["segments"]
            self.segment, self.elapsed = 0, 0.0
            self.released, self.final = message["released"], message["final"]
        elif kind == "extend":
            if message["drive"] != self.drive:
                return "It has another drive."
            self.segments = self.segments[: message["from"]] + message["segments"]
            self.released, self.final = message["released"], message["final"]
        elif kind == "release":
            if message["drive"] != self.drive:
                return "It has another drive."
            self.released = message["released"]
        elif kind in ("hold", "resume"):
            self.held = kind == "hold"
        elif kind == "cancel":
            if message["task"] == self.task:
                self.task, self.phase, self.drive, self.done = None, 0, 0, None
                self.segments, self.segment, self.released = [], 0, 0
        elif kind == "locate":
            if self.drive:
                return "It drives."
            self.pose = message["pose"]
        else:
            return "This robot carries alone."
        return None

    # --- driving ----------------------------------------------------------------------------

    def tick(self):
        self.twist = {"v": 0.0, "w": 0.0}
        left = TICK
        while left > 0 and self.drive and not self.held and self.segment < self.released:
            now = self.segments[self.segment]
            step = min(left, now["t"] - self.elapsed)
            self.advance(now, step)
            self.twist = {"v": now["v"], "w": now["w"]}
            left -= step
            self.elapsed += step
            if self.elapsed >= now["t"] - 1e-9:
                self.segment, self.elapsed = self.segment + 1, 0.0
        if self.drive and self.final and self.segment == len(self.segments):
            self.done = {"task": self.task, "phase": self.phase, "drive": self.drive}
            self.drive, self.segments, self.segment, self.released = 0, [], 0, 0
            return True
        return False

    def advance(self, segment, seconds):
        turn = segment["w"] * seconds
        middle = self.pose["theta"] + turn / 2
        # the chord of the arc
        chord = segment["v"] * seconds * (math.sin(turn / 2) / (turn / 2) if turn else 1)
        theta = self.pose["theta"] + turn
        self.pose = {
            "x": self.pose["x"] + chord * math.cos(middle),
            "y": self.pose["y"] + chord * math.sin(middle),
            "theta": math.atan2(math.sin(theta), math.cos(theta)),
        }

    # --- the connection ---------------------------------------------------------------------

    def say(self, message):
        if self.server:
            try:
                self.server.sendall((json.dumps(message) + "\n").encode())
            except OSError:
                self.server = None

    def live(self):
        ticks = 0
        due = time.monotonic()
        while True:
            due += TICK
            time.sleep(max(0, due - time.monotonic()))
            ticks += 1
            with self.lock:
                ended = self.tick()
                if ended or ticks % 10 == 0:
                    self.say(self.state())
                if self.done and (ended or ticks % 50 == 0):
                    self.say({"type": "done", **self.done})

    def serve(self, connection):
        with connection, connection.makefile("rb") as lines:
            with self.lock:
                self.server = connection
                self.say(self.hello())
            for line in lines:
                with self.lock:
                    answer = self.hear(json.loads(line))
                    if answer:
                        self.say(answer)


def main():
    robot = Robot(sys.argv[1], float(sys.argv[2]), float(sys.argv[3]))
    listener = socket.create_server(("127.0.0.1", 0))
    print(listener.getsockname()[1], file=sys.stderr, flush=True)
    threading.Thread(target=robot.live, daemon=True).start()
    while True:
        connection, _ = listener.accept()
        connection.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        threading.Thread(target=robot.serve, args=(connection,), daemon=True).start()


main()
