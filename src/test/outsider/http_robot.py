#!/usr/bin/env python3
"""A robot on two wheels that knows of Toqa nothing but docs/http-robot.md.

usage: http_robot.py TOKEN      listens on a free port of loopback and prints it on standard error
"""

import json
import math
import sys
import threading
import time
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer

TRACK = 0.30
RADIUS = 0.05
COUNTS_PER_TURN = 4096
MAX_SPEED = 0.6
SILENCE = 0.2
LONGEST_AGE = 400
TICK = 0.005


class Body:
    """Wheels that turn as they are told, at once and exactly."""

    def __init__(self):
        self.lock = threading.Lock()
        self.boot = int(time.time() * 1000)
        self.seq = 0
        self.speeds = [0.0, 0.0]
        self.metres = [0.0, 0.0]
        self.told_at = 0.0
        threading.Thread(target=self.run, daemon=True).start()

    def run(self):
        before = time.monotonic()
        while True:
            time.sleep(TICK)
            now = time.monotonic()
            with self.lock:
                if now - self.told_at > SILENCE:
                    self.speeds = [0.0, 0.0]
                for wheel in range(2):
                    self.metres[wheel] += self.speeds[wheel] * (now - before)
            before = now

    def describe(self):
        with self.lock:
            return {
                "version": 1, "track": TRACK, "wheelRadius": RADIUS, "countsPerTurn": COUNTS_PER_TURN,
                "maxSpeed": MAX_SPEED, "maxLoad": 8, "footprint": 0.35, "boot": self.boot, "seq": self.seq,
            }

    def obey(self, order):
        with self.lock:
            stamp = int(time.monotonic() * 1000)
            if order["seq"] > self.seq and 0 <= stamp - order.get("after", stamp) <= LONGEST_AGE:
                self.seq = order["seq"]
                self.speeds = [self.speed(order["left"]), self.speed(order["right"])]
                self.told_at = time.monotonic()
            left, right = (math.floor(m / (2 * math.pi * RADIUS) * COUNTS_PER_TURN) for m in self.metres)
            return {
                "seq": self.seq, "boot": self.boot, "stamp": stamp,
                "left": left, "right": right, "extra": "is ignored",
            }

    @staticmethod
    def speed(wheel):
        """By amplitude and direction, as a robot would that only sets the power of its motors."""
        return (1 if wheel["forward"] else -1) * wheel["amplitude"] / 255 * MAX_SPEED


class Handler(BaseHTTPRequestHandler):
    protocol_version = "HTTP/1.1"
    disable_nagle_algorithm = True
    wbufsize = 65536

    def answer(self, status, body):
        data = json.dumps(body).encode()
        self.send_response(status)
        self.send_header("Content-Type", "application/json")
        self.send_header("Content-Length", str(len(data)))
        self.end_headers()
        self.wfile.write(data)

    def is_welcome(self):
        if self.headers.get("Authorization") == "Bearer " + TOKEN:
            return True
        self.answer(401, {"error": "the token is wrong"})
        return False

    def do_GET(self):
        if self.is_welcome():
            if self.path == "/v1/robot":
                self.answer(200, BODY.describe())
            else:
                self.answer(404, {"error": "there is no such path"})

    def do_POST(self):
        text = self.rfile.read(int(self.headers.get("Content-Length", 0)))
        if self.is_welcome():
            if self.path == "/v1/wheels":
                self.answer(200, BODY.obey(json.loads(text)))
            else:
                self.answer(404, {"error": "there is no such path"})

    def log_message(self, *arguments):
        pass


TOKEN = sys.argv[1]
BODY = Body()
SERVER = ThreadingHTTPServer(("127.0.0.1", 0), Handler)
print(SERVER.server_address[1], file=sys.stderr, flush=True)
SERVER.serve_forever()
