#include "rigor/view/live/live_access.hpp"

#include <gtest/gtest.h>

namespace rigor::live_access_test {
namespace {

const LiveAccess access_of_test(8080, "abc");

LiveRequestHead good_page() {
  return {.method = "GET", .target = "/?token=abc", .host = "127.0.0.1:8080"};
}
LiveRequestHead good_socket() {
  return {.method = "GET",
          .target = "/live?token=abc",
          .host = "localhost:8080",
          .origin = "http://localhost:8080",
          .is_upgrade = true};
}
unsigned status(const LiveRequestHead& request) {
  return access_of_test.judge(request).status;
}

TEST(LiveAccess, PageAndSocketAreOpenToThoseWithTheToken) {
  EXPECT_EQ(status(good_page()), 200u);
  EXPECT_EQ(status(good_socket()), 101u);
  EXPECT_EQ(access_of_test.url(), "http://127.0.0.1:8080/?token=abc");
}

TEST(LiveAccess, OtherHostsAreMisdirected) {
  for (const char* const host : {"", "evil.example", "127.0.0.1", "127.0.0.1:80", "evil.example:8080",
                                 "127.0.0.1:8080.evil.example", "localhost:8080@evil.example"}) {
    LiveRequestHead request = good_page();
    request.host = host;
    EXPECT_EQ(status(request), 421u) << host;
  }
  LiveRequestHead request = good_page();
  request.host = "[::1]:8080";
  EXPECT_EQ(status(request), 200u);
}

TEST(LiveAccess, WithoutTheTokenNothingIsShown) {
  for (const char* const target :
       {"/", "/?token=", "/?token=abd", "/?token=abcd", "/?token=ab", "/?x=1&token=abc"}) {
    LiveRequestHead request = good_page();
    request.target = target;
    EXPECT_EQ(status(request), 403u) << target;
  }
  LiveRequestHead request = good_socket();
  request.target = "/live?token=no";
  EXPECT_EQ(status(request), 403u);
}

TEST(LiveAccess, ASocketIsForThePageItselfAlone) {
  for (const char* const origin :
       {"", "null", "https://evil.example", "http://127.0.0.1:8080", "http://localhost"}) {
    LiveRequestHead request = good_socket();
    request.origin = origin;
    EXPECT_EQ(status(request), 403u) << origin;
  }
  LiveRequestHead request = good_socket();
  request.is_upgrade = false;
  EXPECT_EQ(status(request), 426u);
}

TEST(LiveAccess, OtherPathsMethodsAndBodiesAreRefused) {
  LiveRequestHead request = good_page();
  request.target = "/../etc/passwd?token=abc";
  EXPECT_EQ(status(request), 404u);
  request = good_page();
  request.method = "POST";
  EXPECT_EQ(status(request), 405u);
  request = good_page();
  request.has_body = true;
  EXPECT_EQ(status(request), 413u);
}

TEST(LiveAccess, TokensAreLongAndNeverTheSame) {
  EXPECT_EQ(make_live_token().size(), 32u);
  EXPECT_NE(make_live_token(), make_live_token());
}

TEST(LiveAccess, PathsOfManyPagesAreThoseOfWhoMakesThem) {
  const LiveAccess many(8080, "abc", true);
  LiveRequestHead request = good_page();
  request.target = "/run/12?token=abc";
  EXPECT_EQ(many.judge(request).status, 200u);
  EXPECT_EQ(many.judge(request).path, "/run/12");
  EXPECT_EQ(status(request), 404u);
  request.target = "/run/12?token=abd";
  EXPECT_EQ(many.judge(request).status, 403u);
  request.target = "/study.js";
  EXPECT_EQ(many.judge(request).resource, LiveAccess::Resource::script);
  EXPECT_EQ(status(request), 404u);
}

}  // namespace
}  // namespace rigor::live_access_test
