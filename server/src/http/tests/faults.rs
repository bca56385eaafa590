//! A fault of the server's own: the client gets a number and not the cause.

use super::Api;

#[tokio::test]
async fn a_broken_database_is_told_without_its_words() {
    let api = Api::local().await;
    api.state.store.close().await;
    let problem = api
        .get("/api/v1/tasks")
        .await
        .problem(500, "internal_error");
    assert!(problem["trace_id"].is_string() && problem["advice"].is_string());
    assert!(!problem.to_string().contains("pool"), "{problem}");
    api.get("/api/v1/health").await.ok(200);
}
