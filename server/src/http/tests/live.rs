//! The live socket's address; what goes through the socket is tested with a real one.

use super::Api;

#[tokio::test]
async fn a_plain_request_is_told_that_a_socket_is_expected() {
    let api = Api::local().await;
    api.get("/api/v1/live")
        .await
        .problem(400, "websocket_expected");
}
